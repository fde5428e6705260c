//! A map as a file: NetCDF (classic format), which xarray, MATLAB and ncdump open. The table of ellipses is in
//! it, so that a user needs one file. The last variable, `checksum`, is the CRC-32 of all bytes before it.

use std::cell::RefCell;
use std::io::{self, Cursor, Seek, SeekFrom, Write};
use std::rc::Rc;
use std::sync::Arc;

use creepage::table::Table;
use netcdf3::{DataSet, FileReader, FileWriter, InvalidDataSet, ReadError, Version, WriteError};

use crate::answer::{HeightOrLoad, State};
use crate::error::MapError;
use crate::map::{ContactMap, Head, MapAccuracy, Spread};
use crate::normal::{HEIGHTS, HeightNode, Heights, PLACE};
use crate::patch::{Ellipse, EllipseSlopes, Patch, Sloped};
use crate::wheel::{CellError, RollingNode, WheelMap};

impl From<WriteError> for MapError {
    fn from(_: WriteError) -> Self {
        Self::Unfit
    }
}

impl From<InvalidDataSet> for MapError {
    fn from(_: InvalidDataSet) -> Self {
        Self::Unfit
    }
}

/// The layout and the meaning of a file's numbers; another number for any change of either.
const FORMAT: i32 = 4;
/// Numbers of an ellipse with its slopes.
const ELLIPSE: usize = 3 * 8;
/// Numbers of a patch.
const PATCH: usize = 4 * 3 + 6 + 2 * ELLIPSE;
const SIDES: [&str; 2] = ["left", "right"];
const COMMENT: &str = "right-hand image of each side; place = y - radius roll - half_distance yaw^2/2; \
    heights: place, roll, z under each of height_loads, then at further rolls of -1, -1/2, 1/2 and 1 of the largest \
    and at yaws of half and the whole square of the largest, under each load, how far aside the contact is one \
    without that turn and by how much z is more; patches: share, angle, y, z, \
    each with its slopes by place and by ln load, approach, centroid x, s, peak pressure, area, residual, then of \
    two ellipses a/b, k_x, k_p, s, weight and three numbers of the moment, then slopes by place and by ln load of \
    ln k_x along and across, ln k_p, s, weight and these three; SI units";

/// A variable of the file.
struct Column {
    name: String,
    dims: Vec<String>,
    values: Vec<f64>,
}

impl ContactMap {
    /// The bytes of the map's file.
    ///
    /// # Errors
    /// [`MapError::Unfit`] where the NetCDF library does not take it.
    pub fn to_bytes(&self) -> Result<Vec<u8>, MapError> {
        let ellipses = self.table.to_bytes().map_err(MapError::Ellipses)?;
        let text = self.source.as_bytes();
        let is_mirrored = Arc::ptr_eq(&self.wheels[0], &self.wheels[1]);
        let sides = if is_mirrored { &SIDES[1..] } else { &SIDES[..] };
        let mut set = DataSet::new();
        set.add_global_attr_string("title", "Contact map of a wheelset")?;
        set.add_global_attr_string("source", concat!("creepage ", env!("CARGO_PKG_VERSION")))?;
        set.add_global_attr_string("comment", COMMENT)?;
        set.add_global_attr_i32("format", vec![FORMAT])?;
        set.add_fixed_dim("wheels", sides.len())?;
        let mut columns = vec![self.head_column(), self.own_column(), self.accuracy_column()];
        for side in sides {
            columns.extend(of_wheel(side, &self.wheels[usize::from(*side == "right")]));
        }
        let sizes = [("height_number", PLACE), ("patch_number", PATCH), ("height_load", HEIGHTS)];
        for (name, size) in sizes.into_iter().chain([("cell_number", 3)]) {
            set.add_fixed_dim(name, size)?;
        }
        for column in &columns {
            let known: usize = column.dims[1..]
                .iter()
                .map(|name| sizes.iter().find(|(n, _)| n == name).map_or(3, |(_, size)| *size))
                .product();
            if set.dim_size(&column.dims[0]).is_none() {
                set.add_fixed_dim(&column.dims[0], column.values.len() / known)?;
            }
            set.add_var_f64(&column.name, &column.dims)?;
        }
        for (name, bytes) in [("ellipses", &ellipses[..]), ("wheelset", text)] {
            let size = format!("{name}_byte");
            // No dimension may be empty.
            set.add_fixed_dim(&size, bytes.len().max(1))?;
            set.add_var_i8(name, &[size])?;
        }
        let scalar: [&str; 0] = [];
        set.add_var_i32("checksum", &scalar)?;
        let buffer = Buffer::default();
        let mut file = FileWriter::open_seek_write("map", Box::new(buffer.clone()))?;
        file.set_def(&set, Version::Offset64Bit, 0)?;
        for column in &columns {
            file.write_var_f64(&column.name, &column.values)?;
        }
        for (name, bytes) in [("ellipses", &ellipses[..]), ("wheelset", text)] {
            let mut signed: Vec<i8> = bytes.iter().map(|byte| byte.cast_signed()).collect();
            if signed.is_empty() {
                signed.push(0);
            }
            file.write_var_i8(name, &signed)?;
        }
        file.write_var_i32("checksum", &[0])?;
        file.close()?;
        sealed(buffer.0.take().into_inner())
    }

    fn head_column(&self) -> Column {
        let Head { radius, half_distance, rail_origins, poisson, friction, yaw, roll, .. } =
            self.head;
        let values = [radius, half_distance, poisson, yaw, roll].into_iter();
        let values = values.chain(rail_origins.into_iter().flatten()).chain(friction).collect();
        Column { name: "head".into(), dims: vec!["head_number".into()], values }
    }

    /// The wheelset's own state; NaN for what is found.
    fn own_column(&self) -> Column {
        let own = self.head.own;
        let [z, load] = match own.pressed {
            HeightOrLoad::Height(z) => [z, f64::NAN],
            HeightOrLoad::AxleLoad(load) => [f64::NAN, load],
        };
        let [roll, rate] = [own.roll, own.pitch_rate].map(|given| given.unwrap_or(f64::NAN));
        let State { y, yaw, speed, lateral_velocity, vertical_velocity, .. } = own;
        let State { roll_rate, yaw_rate, friction, .. } = own;
        let values = vec![
            y,
            z,
            roll,
            yaw,
            load,
            speed,
            rate,
            lateral_velocity,
            vertical_velocity,
            roll_rate,
            yaw_rate,
            friction,
        ];
        Column { name: "own".into(), dims: vec!["own_number".into()], values }
    }

    fn accuracy_column(&self) -> Column {
        let MapAccuracy { tangential, normal, total } = self.accuracy;
        let all = tangential.into_iter().chain(normal).chain(total);
        let values = all.flat_map(|spread| {
            let Spread { states, rms, median, p95, worst } = spread;
            [states as f64, rms, median, p95, worst]
        });
        Column {
            name: "accuracy".into(),
            dims: vec!["accuracy_number".into()],
            values: values.collect(),
        }
    }

    /// Reads a map from the bytes of its file.
    ///
    /// # Errors
    /// [`MapError`] when they are not a whole map.
    pub fn from_bytes(bytes: Vec<u8>) -> Result<Self, MapError> {
        let (body, sum) = bytes.split_last_chunk::<4>().ok_or(MapError::Damaged)?;
        if crc32fast::hash(body) != u32::from_be_bytes(*sum) {
            return Err(MapError::Damaged);
        }
        let file = FileReader::open_seek_read("map", Box::new(Cursor::new(bytes)));
        let mut file = file.map_err(|_: ReadError| MapError::Damaged)?;
        let found = file.data_set().get_global_attr_i32("format").and_then(|one| one.first());
        let found = found.copied().ok_or(MapError::Missing("format"))?;
        if found != FORMAT {
            return Err(MapError::Format { found, known: FORMAT });
        }
        let own = own(&numbers(&mut file, "own")?)?;
        let head = head(&numbers(&mut file, "head")?, own)?;
        let accuracy = accuracy(&numbers(&mut file, "accuracy")?)?;
        let table = Table::from_bytes(bytes_of(&mut file, "ellipses")?);
        let table = Arc::new(table.map_err(MapError::Ellipses)?);
        let source = String::from_utf8(bytes_of(&mut file, "wheelset")?);
        let source = source.map_err(|_| MapError::Senseless("wheelset"))?;
        let count = file.data_set().dim_size("wheels").ok_or(MapError::Missing("wheels"))?;
        let right = Arc::new(wheel(&mut file, "right", (&table, head.poisson))?);
        let left = match count {
            1 => Arc::clone(&right),
            _ => Arc::new(wheel(&mut file, "left", (&table, head.poisson))?),
        };
        Ok(Self { head, table, wheels: [left, right], accuracy, source })
    }
}

fn of_wheel(side: &str, wheel: &WheelMap) -> Vec<Column> {
    let column = |name: &str, dims: &[&str], values: Vec<f64>| {
        let own = |dim: &&str| {
            let shared = dim.ends_with("_number") || *dim == "height_load";
            if shared { (*dim).to_owned() } else { format!("{side}_{dim}") }
        };
        Column { name: format!("{side}_{name}"), dims: dims.iter().map(own).collect(), values }
    };
    let heights = wheel.heights.nodes().iter().flat_map(HeightNode::numbers);
    let loads: Vec<f64> = wheel.loads().collect();
    let records = (0..wheel.places().len()).flat_map(|n| (0..loads.len()).map(move |l| (n, l)));
    let mut patches = Vec::new();
    let mut counts = Vec::new();
    for (node, load) in records {
        let mut count = 0;
        for patch in wheel.patches(node, load) {
            patches.extend(patch_numbers(patch));
            count += 1;
        }
        counts.push(f64::from(count));
    }
    let errors = wheel.errors().iter().flat_map(|error| {
        let CellError { states, tangential, normal } = *error;
        [states as f64, tangential, normal]
    });
    vec![
        column("heights", &["height_place", "height_number"], heights.collect()),
        column("height_loads", &["height_load"], wheel.heights.loads().to_vec()),
        column("places", &["place"], wheel.places().to_vec()),
        column("loads", &["load"], loads),
        column("patch_counts", &["record"], counts),
        column("patches", &["patch", "patch_number"], patches),
        column("errors", &["cell", "cell_number"], errors.collect()),
    ]
}

fn patch_numbers(patch: &Patch) -> [f64; PATCH] {
    let mut all = [0.0; PATCH];
    let sloped = [patch.share, patch.angle, patch.y, patch.z];
    let sloped = sloped.into_iter().flat_map(|s| [s.value, s.by_place, s.by_load]);
    let [x, s] = patch.centroid;
    let others = [patch.approach, x, s, patch.peak_pressure, patch.area, patch.residual];
    let ellipses = patch.ellipses.into_iter().flat_map(|ellipse| {
        let Ellipse { ratio, by_creepage, by_spin, offset, weight, moment, .. } = ellipse;
        let slopes = [ellipse.by_place, ellipse.by_load].into_iter().flat_map(|slopes| {
            let EllipseSlopes { along, across, spin, offset, weight, moment } = slopes;
            [along, across, spin, offset, weight].into_iter().chain(moment)
        });
        [ratio, by_creepage, by_spin, offset, weight].into_iter().chain(moment).chain(slopes)
    });
    all.iter_mut().zip(sloped.chain(others).chain(ellipses)).for_each(|(to, from)| *to = from);
    all
}

fn patch(all: &[f64; PATCH]) -> Patch {
    let sloped = |k: usize| Sloped { value: all[k], by_place: all[k + 1], by_load: all[k + 2] };
    let slopes = |k: usize| EllipseSlopes {
        along: all[k],
        across: all[k + 1],
        spin: all[k + 2],
        offset: all[k + 3],
        weight: all[k + 4],
        moment: [all[k + 5], all[k + 6], all[k + 7]],
    };
    let ellipse = |k: usize| Ellipse {
        ratio: all[k],
        by_creepage: all[k + 1],
        by_spin: all[k + 2],
        offset: all[k + 3],
        weight: all[k + 4],
        moment: [all[k + 5], all[k + 6], all[k + 7]],
        by_place: slopes(k + 8),
        by_load: slopes(k + 16),
    };
    Patch {
        share: sloped(0),
        angle: sloped(3),
        y: sloped(6),
        z: sloped(9),
        approach: all[12],
        centroid: [all[13], all[14]],
        peak_pressure: all[15],
        area: all[16],
        residual: all[17],
        ellipses: [ellipse(18), ellipse(18 + ELLIPSE)],
    }
}

fn own(all: &[f64]) -> Result<State, MapError> {
    let &[
        y,
        z,
        roll,
        yaw,
        load,
        speed,
        rate,
        lateral_velocity,
        vertical_velocity,
        roll_rate,
        yaw_rate,
        friction,
    ] = all
    else {
        return Err(MapError::Missing("own"));
    };
    let given = |value: f64| (!value.is_nan()).then_some(value);
    let pressed = given(z).map_or(HeightOrLoad::AxleLoad(load), HeightOrLoad::Height);
    let (roll, pitch_rate) = (given(roll), given(rate));
    Ok(State {
        y,
        yaw,
        roll,
        pressed,
        speed,
        pitch_rate,
        lateral_velocity,
        vertical_velocity,
        roll_rate,
        yaw_rate,
        friction,
    })
}

fn head(all: &[f64], own: State) -> Result<Head, MapError> {
    match *all {
        [radius, half_distance, poisson, yaw, roll, y, z, other_y, other_z, low, high] => {
            Ok(Head {
                radius,
                half_distance,
                rail_origins: [[y, z], [other_y, other_z]],
                poisson,
                friction: [low, high],
                yaw,
                roll,
                own,
            })
        }
        _ => Err(MapError::Missing("head")),
    }
}

fn accuracy(all: &[f64]) -> Result<MapAccuracy, MapError> {
    let (four, rest) = all.as_chunks::<5>();
    let &[a, b, c, d, e, f] = four else { return Err(MapError::Missing("accuracy")) };
    if !rest.is_empty() {
        return Err(MapError::Missing("accuracy"));
    }
    let spread = |[states, rms, median, p95, worst]: [f64; 5]| Spread {
        states: count(states),
        rms,
        median,
        p95,
        worst,
    };
    Ok(MapAccuracy {
        tangential: [spread(a), spread(b)],
        normal: [spread(c), spread(d)],
        total: [spread(e), spread(f)],
    })
}

/// A count that was written as a number; 0 for what is none.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
fn count(value: f64) -> usize {
    value.clamp(0.0, 1e9) as usize
}

fn wheel(file: &mut FileReader, side: &str, table: (&Table, f64)) -> Result<WheelMap, MapError> {
    let mut column = |name: &'static str| {
        let known = format!("{side}_{name}");
        numbers_of(file, &known).ok_or(MapError::Missing(name))
    };
    let heights = column("heights")?;
    let nodes = heights.as_chunks::<PLACE>().0.iter().map(HeightNode::of_numbers);
    let loads = <[f64; HEIGHTS]>::try_from(column("height_loads")?);
    let loads = loads.map_err(|_| MapError::Missing("height_loads"))?;
    let heights = Heights::new(nodes.collect(), loads)?;
    let (places, loads) = (column("places")?, column("loads")?);
    let (counts, patches) = (column("patch_counts")?, column("patches")?);
    if counts.len() != places.len() * loads.len() || loads.is_empty() {
        return Err(MapError::Missing("patch_counts"));
    }
    if !patches.iter().all(|number| number.is_finite()) {
        return Err(MapError::Senseless("patches"));
    }
    let mut all = patches.as_chunks::<PATCH>().0.iter().map(patch);
    let mut records = counts.iter().map(|n| all.by_ref().take(count(*n)).collect::<Vec<_>>());
    let nodes: Vec<RollingNode> = places
        .iter()
        .map(|place| RollingNode {
            place: *place,
            loads: records.by_ref().take(loads.len()).collect(),
        })
        .collect();
    let errors = column("errors")?;
    let errors = errors.as_chunks::<3>().0.iter().map(|&[states, tangential, normal]| CellError {
        states: count(states),
        tangential,
        normal,
    });
    WheelMap::new(heights, &nodes, &loads, errors.collect(), table)
}

fn numbers(file: &mut FileReader, name: &'static str) -> Result<Vec<f64>, MapError> {
    numbers_of(file, name).ok_or(MapError::Missing(name))
}

fn numbers_of(file: &mut FileReader, name: &str) -> Option<Vec<f64>> {
    file.data_set().get_var(name)?;
    file.read_var_f64(name).ok()
}

fn bytes_of(file: &mut FileReader, name: &'static str) -> Result<Vec<u8>, MapError> {
    let signed = file.read_var_i8(name).map_err(|_| MapError::Missing(name))?;
    Ok(signed.into_iter().map(i8::cast_unsigned).collect())
}

/// Puts the checksum of all other bytes into the last four.
fn sealed(mut bytes: Vec<u8>) -> Result<Vec<u8>, MapError> {
    let (body, sum) = bytes.split_last_chunk_mut::<4>().ok_or(MapError::Damaged)?;
    *sum = crc32fast::hash(body).to_be_bytes();
    Ok(bytes)
}

/// Bytes that are still at hand when the writer of the format is done with them.
#[derive(Clone, Default)]
struct Buffer(Rc<RefCell<Cursor<Vec<u8>>>>);

impl Write for Buffer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Buffer {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.borrow_mut().seek(to)
    }
}
