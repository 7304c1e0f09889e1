//! The tables of docs/ranges.md, from the lines of a file.

/// A line, as far as it counts.
struct Line {
    side: String,
    what: String,
    proved: f64,
    reached: f64,
    proof_ends: String,
    motion_ends: String,
    part: f64,
    alone: f64,
}

impl Line {
    fn of(text: &str) -> Line {
        let words: Vec<&str> = text.split(',').collect();
        let number = |i: usize| words[i].parse().expect("a number");
        Line {
            side: words[1].into(),
            what: words[2].into(),
            proved: number(3),
            reached: number(4),
            proof_ends: words[5].into(),
            motion_ends: words[6].into(),
            part: number(7),
            alone: number(8),
        }
    }

    fn is_orbit(&self) -> bool {
        self.what.parse::<u64>().is_ok()
    }

    /// A depth as a part of the drive's amplitude at the touch.
    fn part(&self, depth: f64) -> f64 {
        if self.side == "beyond" { depth / (1.0 - depth) } else { depth / (1.0 + depth) }
    }

    /// Proved over true.
    fn ratio(&self) -> f64 {
        self.proved / self.reached
    }

    fn is_long(&self) -> bool {
        self.part(self.reached) >= 0.01
    }
}

/// Numbers at these shares of a list.
fn quantiles(mut all: Vec<f64>, shares: &[f64]) -> String {
    all.sort_by(f64::total_cmp);
    let at = |share: &f64| {
        let place = (share * (all.len() as f64 - 1.0)).round() as usize;
        all.get(place).map_or("–".into(), |x| format!("{x:.3}"))
    };
    shares.iter().map(at).collect::<Vec<_>>().join(", ")
}

/// What is told of some lines.
struct Group<'a> {
    name: &'static str,
    lines: Vec<&'a Line>,
}

fn groups(all: &[Line]) -> Vec<Group<'_>> {
    let of = |name, side: &str, kind: &dyn Fn(&Line) -> bool| Group {
        name,
        lines: all.iter().filter(|line| line.side == side && kind(line)).collect(),
    };
    let is = |what: &'static str| move |line: &Line| line.what == what;
    vec![
        of("before, several periods", "before", &is("chaos")),
        of("before, one orbit", "before", &is("one")),
        of("before, each orbit of one impact of several", "before", &Line::is_orbit),
        of("beyond, several periods", "beyond", &is("chaos")),
        of("beyond, one orbit", "beyond", &is("one")),
        of("beyond, each orbit of one impact of several", "beyond", &Line::is_orbit),
        of("beyond, nothing", "beyond", &is("nothing")),
    ]
}

impl Group<'_> {
    /// How many reach parts of the amplitude.
    fn counts(&self, depth: impl Fn(&Line) -> f64) -> [usize; 4] {
        [0.001, 0.01, 0.1, 0.5]
            .map(|least| self.lines.iter().filter(|line| line.part(depth(line)) >= least).count())
    }

    fn row(&self) -> String {
        let [proved, reached] = [self.counts(|line| line.proved), self.counts(|line| line.reached)];
        let nothing = self.lines.iter().all(|line| line.what == "nothing");
        let both = |i: usize| match nothing {
            true => proved[i].to_string(),
            false => format!("{} / {}", proved[i], reached[i]),
        };
        let known = self.lines.iter().filter(|line| line.reached > 0.0 && !nothing);
        let long = self.lines.iter().filter(|line| line.is_long() && !nothing);
        format!(
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            self.name,
            self.lines.len(),
            both(0),
            both(1),
            both(2),
            both(3),
            quantiles(known.map(|line| line.ratio()).collect(), &[0.25, 0.5]),
            quantiles(long.map(|line| line.ratio()).collect(), &[0.05, 0.25, 0.5]),
        )
    }

    /// What the proof ends by, what the motions do, and how often.
    fn ends(&self) -> String {
        let mut ends: Vec<(String, usize)> = Vec::new();
        for line in &self.lines {
            let end = match &line.motion_ends[..] {
                "" => line.proof_ends.clone(),
                motion => format!("{} ({motion})", line.proof_ends),
            };
            match ends.iter_mut().find(|(known, _)| *known == end) {
                Some((_, count)) => *count += 1,
                None => ends.push((end, 1)),
            }
        }
        ends.sort_by(|(a, m), (b, n)| n.cmp(m).then(a.cmp(b)));
        let ends: Vec<String> = ends.iter().map(|(end, count)| format!("{end} {count}")).collect();
        format!("| {} | {} |", self.name, ends.join(", "))
    }

    fn median(&self, some: impl Fn(&Line) -> Option<f64>) -> String {
        quantiles(self.lines.iter().filter_map(|line| some(line)).collect(), &[0.5])
    }
}

/// How many, of how many, in percent.
pub fn share(some: usize, all: usize) -> String {
    format!("{:.1} % ({some} of {all})", 100.0 * some as f64 / all as f64)
}

pub fn print(text: &str) {
    let all: Vec<Line> = text.lines().skip(1).map(Line::of).collect();
    let groups = groups(&all);
    let [before, _, _, beyond, ..] = &groups[..] else { return };
    println!(
        "| what is born | sides | ≥ 0.1 % | ≥ 1 % | ≥ 10 % | ≥ 50 % | proved over true: quartile, median | where ≥ 1 % in truth: 5 %, quartile, median |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: | --- | --- |");
    groups.iter().for_each(|group| println!("{}", group.row()));
    println!("\n| what is born | proof ends by (in truth) |\n| --- | --- |");
    groups.iter().for_each(|group| println!("{}", group.ends()));
    println!("\n| | wanted | found |\n| --- | --- | --- |");
    let orbits: Vec<&Line> =
        all.iter().filter(|line| (line.is_orbit() || line.what == "one") && line.reached > 0.0).collect();
    let near = orbits.iter().filter(|line| line.ratio() >= 0.95).count();
    println!(
        "| orbits of one impact, proved to 0.95 of their true end | 99 % | {} |",
        share(near, orbits.len())
    );
    for (side, group, wanted) in [("before", before, "0.9"), ("beyond", beyond, "0.95")] {
        let ratio = |line: &Line| (line.reached > 0.0).then(|| line.ratio());
        println!(
            "| several periods {side}, median of proved over true | {wanted} | {} |",
            group.median(ratio)
        );
    }
    let long: Vec<&Line> = all.iter().filter(|line| !line.is_orbit() && line.is_long()).collect();
    let half = long.iter().filter(|line| line.ratio() >= 0.5).count();
    println!(
        "| sides with a true range of 1 % or more, proved to half of it | 95 % | {} |",
        share(half, long.len())
    );
    let nothing = &groups[6];
    println!(
        "| nothing born, proved to 1 % or more | 75 % | {} |",
        share(nothing.counts(|line| line.proved)[1], nothing.lines.len())
    );
    for (side, one) in [("before", &groups[1]), ("beyond", &groups[4])] {
        let alone = |line: &Line| (line.proved > 0.0).then(|| line.alone / line.proved);
        println!("| no others, one orbit {side}: median part of its range | 0.8 | {} |", one.median(alone));
    }
    for (side, group) in [("before", before), ("beyond", beyond)] {
        let from = group.lines.iter().filter(|line| line.alone > 0.0).count();
        println!(
            "| no others, several periods {side}: from the touch on | 80 % | {} |",
            share(from, group.lines.len())
        );
    }
    let open = all.iter().filter(|line| line.what == "open").count();
    let farther = all.iter().filter(|line| line.part > line.proved).count();
    let false_ends = all.iter().filter(|line| line.reached > 0.0 && line.ratio() > 1.002).count();
    println!(
        "\n{open} sides are open: what is born there is not decided. A part goes farther than the whole on {farther}.\nProved beyond the true end: {false_ends}."
    );
}
