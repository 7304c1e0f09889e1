//! The paper's oscillator as a machine.

/// Section 4.2 of the paper as a machine, in seconds and with a mass of 2.
pub const PAPER_MACHINE: &str = r#"
format = "grazing-scene 2"
title = "section 4.2 of the paper as a machine, in seconds"
[parameters]
d = 0.6
w = 4.9
mu = -0.05
[system]
period = 3
mass = 2
stiffness = "2*(2*pi/3)^2/w^2"
damping = "2*(2*pi/3)*2*d/w"
[[walls]]
name = "plate"
offset = -1
harmonics = [{ k = 1, cos = "1 + mu" }]
restitution = 1
"#;
