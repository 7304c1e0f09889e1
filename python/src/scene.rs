//! Scenes: read, changed, run.

use std::{path::PathBuf, sync::Arc};

use grazing_scenes::{
    Error, Result,
    answer::scene_of,
    num_rational::BigRational,
    run::{Job, Surroundings, TaskReport, run_task},
    scene::{Body, Scene as Inner, Task},
};
use numpy::{PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray3, PyUntypedArrayMethods};
use pyo3::{
    prelude::*,
    types::{PyDict, PyString},
};

use crate::{
    arrays::{Collector, Data},
    batch::{Plan, coordinates, follow},
    exact::Exact,
    failure::raise,
    watch::{watched, watched_here},
};

/// A scene as the library holds it. Users have `grazing.Scene`.
#[pyclass(frozen, module = "grazing._grazing", name = "Scene")]
pub struct Scene {
    inner: Arc<Inner>,
    text: String,
    name: String,
}

/// The report as JSON and as text, what is kept beside it, rows of a table as JSON, certificates, a failure.
type Answer<'py> =
    (String, String, Bound<'py, PyDict>, Option<String>, Vec<(String, String)>, Option<Failure>);

/// Of a failed task: the message, the line of its scene, and whether a file or stream was at fault.
type Failure = (String, Option<usize>, bool);

#[pymethods]
impl Scene {
    /// From TOML text; `name` leads every error message.
    #[staticmethod]
    fn from_toml(py: Python<'_>, text: String, name: String) -> PyResult<Scene> {
        watched(py, None, move |_| Ok(Scene { inner: Arc::new(Inner::from_toml(&text, &name)?), text, name }))
    }

    /// A machine as it is typed.
    #[staticmethod]
    fn from_words(py: Python<'_>, words: String) -> PyResult<Scene> {
        let text = scene_of(&words).map_err(|error| raise(py, &error))?;
        Scene::from_toml(py, text, "machine.toml".into())
    }

    #[getter]
    fn title(&self) -> &str {
        &self.inner.title
    }

    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    #[getter]
    fn is_machine(&self) -> bool {
        !matches!(self.inner.body, Body::Oscillator(_))
    }

    /// How many displacements a state of it has.
    #[getter]
    fn coordinates(&self) -> usize {
        coordinates(&self.inner)
    }

    #[getter]
    fn parameters(&self) -> Vec<(String, BigRational)> {
        self.inner.parameters.clone()
    }

    /// Name, group, kind, and the parameters that it sets.
    #[getter]
    #[allow(clippy::type_complexity)]
    fn tasks(&self) -> Vec<(String, Option<String>, &'static str, Vec<(String, BigRational)>)> {
        let one = |task: &Task| (task.name.clone(), task.group.clone(), task.kind.word(), task.set.clone());
        self.inner.tasks.iter().map(one).collect()
    }

    /// Whether nothing tells them apart: names, texts, files beside them, parameters.
    fn is_same(&self, other: &Scene) -> bool {
        self.inner == other.inner && self.text == other.text && self.name == other.name
    }

    /// The same with other values of some parameters.
    fn with_parameters(&self, py: Python<'_>, changes: Vec<(String, Given)>) -> PyResult<Scene> {
        let changes = self.exact(py, &changes)?;
        let inner = self.inner.with(&changes).map_err(|error| raise(py, &error))?;
        Ok(Scene { inner: Arc::new(inner), text: self.text.clone(), name: self.name.clone() })
    }

    /// Runs one task. What fails in it is in the report.
    #[pyo3(signature = (task, changes, folder, progress))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        task: usize,
        changes: Vec<(String, Given)>,
        folder: Option<PathBuf>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Answer<'py>> {
        let changes = self.exact(py, &changes)?;
        let scene = self.inner.clone();
        let (report, data) = watched(py, progress.as_ref(), move |watch| {
            let around = Surroundings { changes: &changes, folder: folder.as_deref(), monitor: watch };
            let job = Job::new(&scene, task_of(&scene, task)?, around)?;
            let mut collector = Collector::default();
            let report = run_task(&job, &mut collector);
            Ok((report, collector.data))
        })?;
        answer(py, &report, data)
    }

    /// Runs the two tasks of a page of answer: the page, its sentences, each after its mark, and the report
    /// of each task.
    #[allow(clippy::type_complexity)]
    fn answer<'py>(
        &self,
        py: Python<'py>,
        changes: Vec<(String, Given)>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(String, Vec<(String, String)>, Vec<Answer<'py>>)> {
        let changes = self.exact(py, &changes)?;
        let scene = self.inner.clone();
        let (page, found) = watched(py, progress.as_ref(), move |watch| {
            let around = Surroundings { changes: &changes, folder: None, monitor: watch };
            let mut found = Vec::new();
            let page = grazing_scenes::answer::answer(&scene, around, |job| {
                let mut collector = Collector::default();
                let report = run_task(job, &mut collector);
                found.push((report.clone(), collector.data));
                Ok(report)
            })?;
            Ok((page, found))
        })?;
        let sentences = page.sentences().into_iter().map(|said| (said.mark.to_string(), said.text.clone()));
        let reports = found.into_iter().map(|(report, data)| answer(py, &report, data));
        Ok((page.to_string(), sentences.collect(), reports.collect::<PyResult<_>>()?))
    }

    /// Checks all that can be checked of a task before it runs.
    fn check(&self, py: Python<'_>, task: usize, changes: Vec<(String, Given)>) -> PyResult<()> {
        let changes = self.exact(py, &changes)?;
        let scene = self.inner.clone();
        watched(py, None, move |_| {
            let around = Surroundings { changes: &changes, ..Surroundings::default() };
            Job::new(&scene, task_of(&scene, task)?, around).map(drop)
        })
    }

    /// Follows many motions: see `grazing.Scene.simulate`. Writes `points[i, record]`, `impacts[i]`,
    /// `ends[i]`.
    #[allow(clippy::too_many_arguments)]
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        starts: PyReadonlyArray2<'py, f64>,
        varied: Vec<String>,
        values: PyReadonlyArray2<'py, f64>,
        phase: f64,
        transient: u64,
        every: u64,
        mut points: PyReadwriteArray3<'py, f64>,
        mut impacts: PyReadwriteArray1<'py, u64>,
        mut ends: PyReadwriteArray1<'py, u8>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> PyResult<()> {
        let records = points.shape()[1];
        let plan = Plan {
            scene: &self.inner,
            coordinates: coordinates(&self.inner),
            starts: starts.as_slice()?,
            varied: &varied,
            values: values.as_slice()?,
            phase,
            transient,
            every,
            records,
        };
        let (points, impacts) = (points.as_slice_mut()?, impacts.as_slice_mut()?);
        let ends = ends.as_slice_mut()?;
        watched_here(py, progress.as_ref(), |watch| follow(&plan, points, impacts, ends, watch))
    }
}

fn task_of(scene: &Inner, index: usize) -> Result<&Task> {
    scene.tasks.get(index).ok_or_else(|| Error::input(format!("there is no task {index}")))
}

/// A value of a parameter as it is written: the scene reads it, in its units.
struct Given(String);

impl<'a, 'py> FromPyObject<'a, 'py> for Given {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Given> {
        match object.cast::<PyString>() {
            Ok(text) => Ok(Given(text.to_string())),
            Err(_) => Ok(Given(Exact::extract(object)?.0.to_string())),
        }
    }
}

impl Scene {
    fn exact(&self, py: Python<'_>, changes: &[(String, Given)]) -> PyResult<Vec<(String, BigRational)>> {
        let texts: Vec<_> = changes.iter().map(|(name, value)| (name.as_str(), value.0.as_str())).collect();
        self.inner.values(&texts).map_err(|error| raise(py, &error))
    }
}

fn answer<'py>(py: Python<'py>, report: &TaskReport, mut data: Data) -> PyResult<Answer<'py>> {
    let text = serde_json::to_string(report);
    let text = text.map_err(|error| raise(py, &std::io::Error::other(error).into()))?;
    let (rows, certificates) = (data.rows.take(), std::mem::take(&mut data.certificates));
    let failed = match &report.status {
        grazing_scenes::run::Status::Failed { reason, at, io } => Some((reason.clone(), at.line, *io)),
        _ => None,
    };
    Ok((text, report.to_string(), data.into_dict(py)?, rows, certificates, failed))
}
