//! Broadcast arguments: numbers, or anything of which NumPy makes an array of floats.

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyTuple};

/// An argument before it meets the others.
pub(crate) enum Number<'py> {
    One(f64),
    Many(Bound<'py, PyAny>),
}

impl<'py> FromPyObject<'_, 'py> for Number<'py> {
    type Error = PyErr;

    fn extract(value: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(float) = value.cast::<PyFloat>() {
            return Ok(Self::One(float.value()));
        }
        if value.is_instance_of::<PyInt>() {
            return value.extract().map(Self::One);
        }
        Ok(Self::Many(value.to_owned()))
    }
}

/// The numbers of a call, broadcast to one shape.
pub(crate) struct Inputs<'py, const N: usize> {
    pub(crate) shape: Vec<usize>,
    held: [Argument<'py>; N],
}

/// One argument: the same number for all elements, or one each in C order.
enum Argument<'py> {
    One(f64),
    Many(PyReadonlyArrayDyn<'py, f64>),
}

/// The same, as threads without Python can read it.
#[derive(Clone, Copy)]
pub(crate) enum Column<'a> {
    One(f64),
    Many(&'a [f64]),
}

impl Column<'_> {
    pub(crate) fn at(&self, index: usize) -> f64 {
        match self {
            Self::One(value) => *value,
            Self::Many(values) => values[index],
        }
    }
}

impl<'py, const N: usize> Inputs<'py, N> {
    /// `names` are for messages.
    pub(crate) fn new(
        py: Python<'py>,
        names: [&'static str; N],
        mut numbers: [Number<'py>; N],
    ) -> PyResult<Self> {
        by_dimension(py, &mut numbers)?;
        let mut arrays = Vec::with_capacity(N);
        for (name, number) in names.into_iter().zip(numbers) {
            arrays.push(match number {
                Number::One(value) => Err(value),
                Number::Many(value) => Ok(floats(py, name, &value)?),
            });
        }
        let shapes = || arrays.iter().flatten().map(PyUntypedArrayMethods::shape);
        let shape = broadcast(shapes()).ok_or_else(|| {
            let shapes: Vec<_> = shapes().collect();
            PyValueError::new_err(format!(
                "{} of shapes {shapes:?} cannot be broadcast together",
                names.join(", ")
            ))
        })?;
        let mut held = Vec::with_capacity(N);
        for array in arrays {
            held.push(match array {
                Err(value) => Argument::One(value),
                Ok(array) => hold(py, array, &shape)?,
            });
        }
        let held = held.try_into().map_err(|_| PyValueError::new_err("arguments are missing"))?;
        Ok(Self { shape, held })
    }

    /// The numbers, when there is only one of each.
    pub(crate) fn scalars(&self) -> Option<[f64; N]> {
        let values = self.held.each_ref().map(|held| match held {
            Argument::One(value) => *value,
            Argument::Many(_) => f64::NAN,
        });
        self.shape.is_empty().then_some(values)
    }

    pub(crate) fn columns(&self) -> PyResult<[Column<'_>; N]> {
        let mut columns = [Column::One(f64::NAN); N];
        for (column, held) in columns.iter_mut().zip(&self.held) {
            *column = match held {
                Argument::One(value) => Column::One(*value),
                Argument::Many(array) => Column::Many(array.as_slice()?),
            };
        }
        Ok(columns)
    }
}

/// Arrays of xarray are broadcast against each other by the names of their dimensions.
fn by_dimension<'py>(py: Python<'py>, numbers: &mut [Number<'py>]) -> PyResult<()> {
    let mut named = Vec::new();
    for number in numbers {
        let Number::Many(value) = number else { continue };
        if value.cast_exact::<PyArrayDyn<f64>>().is_err() && value.hasattr("dims")? {
            named.push(value);
        }
    }
    if named.len() > 1 {
        let arrays = PyTuple::new(py, named.iter().map(|value| &**value))?;
        let together = py.import("xarray")?.call_method1("broadcast", arrays)?;
        for (value, array) in named.into_iter().zip(together.try_iter()?) {
            *value = array?;
        }
    }
    Ok(())
}

/// An array of floats; refuses what would lose its meaning, such as text and complex numbers.
fn floats<'py>(
    py: Python<'py>,
    name: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    if let Ok(array) = value.cast_exact::<PyArrayDyn<f64>>() {
        return Ok(array.clone());
    }
    let numpy = py.import("numpy")?;
    if numpy.getattr("ma")?.call_method1("is_masked", (value,))?.is_truthy()? {
        return Err(PyTypeError::new_err(format!("{name} must not have masked elements")));
    }
    let array = numpy.call_method1("asarray", (value,))?;
    let (dtype, float64) = (array.getattr("dtype")?, numpy.getattr("float64")?);
    if !numpy.call_method1("can_cast", (&dtype, &float64, "same_kind"))?.is_truthy()? {
        let message = format!("{name} must be real numbers, not an array of {dtype}");
        return Err(PyTypeError::new_err(message));
    }
    Ok(array.call_method1("astype", (float64,))?.cast_into()?)
}

/// Reads an array as if it had that shape; copies only what does not lie in order.
fn hold<'py>(
    py: Python<'py>,
    array: Bound<'py, PyArrayDyn<f64>>,
    shape: &[usize],
) -> PyResult<Argument<'py>> {
    if array.ndim() == 0 {
        return Ok(Argument::One(array.extract()?));
    }
    let numpy = py.import("numpy")?;
    let mut array = array.into_any();
    if !array.cast::<PyArrayDyn<f64>>()?.shape().eq(shape) {
        array = numpy.call_method1("broadcast_to", (array, PyTuple::new(py, shape)?))?;
    }
    let in_order = numpy.call_method1("require", (array, numpy.getattr("float64")?, "CA"))?;
    Ok(Argument::Many(in_order.cast_into::<PyArrayDyn<f64>>()?.try_readonly()?))
}

/// NumPy's rule: sizes of one stretch, others must agree, from the last dimension on.
fn broadcast<'a>(shapes: impl Iterator<Item = &'a [usize]>) -> Option<Vec<usize>> {
    let mut common = Vec::new();
    for shape in shapes {
        if shape.len() > common.len() {
            common.splice(0..0, vec![1; shape.len() - common.len()]);
        }
        let offset = common.len() - shape.len();
        for (size, own) in common[offset..].iter_mut().zip(shape) {
            if *size == 1 {
                *size = *own;
            } else if *own != 1 && own != size {
                return None;
            }
        }
    }
    Some(common)
}
