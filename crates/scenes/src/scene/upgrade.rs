//! A scene of an older format, written in format 3: the same file with other names of keys, its comments and
//! its layout as they are.

use toml_edit::{DocumentMut, Value};

use super::{
    format::{SceneFormat, translate},
    scene::{Body, Scene},
};
use crate::error::{Error, Result};

impl Scene {
    /// The text of a scene in format 3; what is in format 3 is left as it is. What is read from it is the
    /// same as from `text`, which is checked. `name` leads every error message.
    ///
    /// ```
    /// use grazing_scenes::scene::Scene;
    /// let text = "format = \"grazing-scene 1\" # old\ntitle = \"a ball\"\n[system]\nforce = -1\n[[walls]]\n\
    ///             side = \"lower\"\noffset = 0\nrestitution = 1\n";
    /// let new = Scene::upgraded(text, "ball.toml")?;
    /// assert!(new.starts_with("format = \"grazing-scene 3\" # old\n") && new.contains("\n[[stops]]\n"));
    /// # Ok::<(), grazing_scenes::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Scene::from_toml`].
    pub fn upgraded(text: &str, name: &str) -> Result<String> {
        let scene = Scene::from_toml(text, name)?;
        if scene.format == SceneFormat::Three {
            return Ok(text.to_string());
        }
        let wrong = |message: &dyn std::fmt::Display| Error::input(format!("{name}: {message}"));
        let mut document: DocumentMut = text.parse().map_err(|error: toml_edit::TomlError| wrong(&error))?;
        translate(document.as_table_mut(), scene.format, &written)
            .map_err(|foreign| wrong(&foreign.message))?;
        set(&mut document, "format", SceneFormat::Three.word());
        let again = |document: &DocumentMut| Scene::from_toml(&document.to_string(), name);
        let mut read = again(&document)?;
        if matches!((&scene.body, &read.body), (Body::Machine(_), Body::Oscillator(_))) {
            // The other engine's last digits are others.
            set(&mut document, "engine", "many");
            read = again(&document)?;
        }
        if !read.says_the_same(&scene) {
            return Err(wrong(&"is not the same scene in format 3, which is a fault of this program"));
        }
        Ok(document.to_string())
    }

    /// Whether the two differ by their files' texts and formats alone.
    fn says_the_same(&self, other: &Scene) -> bool {
        let said = |scene: &Scene| {
            let Scene { title, parameters, body, stops, mass, accuracy, tasks, .. } = scene.clone();
            (title, parameters, body, stops, mass, accuracy, tasks)
        };
        said(self) == said(other)
    }
}

/// A number as it stands in the file, or a text.
fn written(value: &Value) -> Option<String> {
    Some(match value {
        Value::String(text) => text.value().clone(),
        Value::Integer(number) => number.display_repr().replace('_', ""),
        Value::Float(number) => number.display_repr().replace('_', ""),
        _ => return None,
    })
}

/// Gives a key of the top level a text, what stands around it left as it is.
fn set(document: &mut DocumentMut, key: &str, text: &str) {
    let mut value = Value::from(text);
    match document.get_mut(key).and_then(toml_edit::Item::as_value_mut) {
        Some(old) => {
            *value.decor_mut() = old.decor().clone();
            *old = value;
        }
        None => drop(document.insert(key, toml_edit::Item::Value(value))),
    }
}
