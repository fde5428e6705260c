//! `contact.vtk`: the elements as quadrilaterals, in SI units, for `ParaView` and others that read
//! VTK's legacy format.

use creepage::Region;
use creepage::coulomb::ElementField;

use super::view::OnAreas;
use crate::vtk::Vtk;

impl OnAreas<'_> {
    /// The elements with pressure, tractions, areas, and slip and frictional power where the theory
    /// gives them.
    pub(crate) fn vtk(&self) -> String {
        let (elements, scaling) = (self.elements, self.scaling);
        let count = elements.len();
        let mut vtk = Vtk(format!(
            "# vtk DataFile Version 3.0\n\
             creepage {}: theory {}; SI units, on the lower body, x along rolling\n\
             ASCII\nDATASET POLYDATA\nPOINTS {} float\n",
            env!("CARGO_PKG_VERSION"),
            self.solved.theory.name,
            4 * count,
        ));
        let corners = elements.iter().flat_map(|element| element.corners);
        vtk.rows(corners.map(|[x, y]| [x * scaling.length, y * scaling.length, 0.0]));
        vtk.line(&format!("POLYGONS {count} {}", 5 * count));
        for i in 0..count {
            let first = 4 * i;
            vtk.line(&format!("4 {first} {} {} {}", first + 1, first + 2, first + 3));
        }
        vtk.line(&format!("CELL_DATA {count}"));
        let pressure = scaling.traction / self.solved.case.friction();
        vtk.scalars("pressure_pa", elements.iter().map(|element| pressure * element.bound));
        let traction =
            |element: &ElementField| element.point.traction.map(|t| t * scaling.traction);
        vtk.vectors("traction_pa", elements.iter().map(traction));
        let sticks =
            |element: &ElementField| f64::from(u8::from(element.point.region == Region::Adhesion));
        vtk.scalars("adhesion", elements.iter().map(sticks));
        if elements.iter().all(|element| element.point.slip.iter().all(|slip| slip.is_finite())) {
            let slip = |element: &ElementField| element.point.slip.map(|s| s * scaling.slip);
            vtk.vectors("slip", elements.iter().map(slip));
            let power = |element: &ElementField| {
                let (traction, slip) = (traction(element), slip(element));
                traction[0] * slip[0] + traction[1] * slip[1]
            };
            vtk.scalars("frictional_power_per_metre_j_per_m3", elements.iter().map(power));
        }
        vtk.0
    }
}
