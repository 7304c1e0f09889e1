//! The same scene in format 3.

use grazing_scenes::scene::Scene;
use toml::Table;

use super::{Form, Level, form, without};
use crate::forms::{report::refusals, scenes::NAME};

pub(super) fn upgraded(base: &Table) -> Option<Form> {
    if base["format"].as_str() == Some("grazing-scene 3") {
        return None;
    }
    let accepted = without(base, refusals(base).keys());
    let text = toml::to_string(&accepted).expect("a table");
    let mut form = form("upgraded to format 3", Level::Same, base);
    form.scene = toml::from_str(&Scene::upgraded(&text, NAME).expect("a scene")).expect("a table");
    assert_eq!(form.scene["format"].as_str(), Some("grazing-scene 3"));
    Some(form)
}
