//! A machine as somebody types it: its scene.

use grazing_scenes::answer::scene_of;
use serde_json::json;

use crate::answer::{Fault, json};

/// Of a machine's text, as `m = 2 kg, k = 800 N/m, …`, the text of the scene: `{"scene"}`.
pub fn machine(text: &str) -> String {
    json(scene_of(text).map(|scene| json!({ "scene": scene })).map_err(|error| Fault::new(error.to_string())))
}
