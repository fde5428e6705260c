//! `modelDescription.xml` of both versions, from the table of variables.

use std::fmt::Write as _;

use crate::instance::Inputs;
use crate::pack::Version;
use crate::variables::{
    Causality, FIRST_REAL, FIRST_SWITCH, INPUTS, REALS, Real, SWITCHES, Switch,
};

/// Name of the library without its ending, and of the model in C.
pub(crate) const IDENTIFIER: &str = "creepage_fmu";

/// Units with their exponents of kg, m, s, rad.
const UNITS: [(&str, [i32; 4]); 10] = [
    ("1", [0, 0, 0, 0]),
    ("m", [0, 1, 0, 0]),
    ("rad", [0, 0, 0, 1]),
    ("m/s", [0, 1, -1, 0]),
    ("rad/s", [0, 0, -1, 1]),
    ("rad/m", [0, -1, 0, 1]),
    ("N", [1, 1, -2, 0]),
    ("N.m", [1, 2, -2, 0]),
    ("J/m", [1, 1, -2, 0]),
    ("s", [0, 0, 1, 0]),
];

/// The description for inputs that start so.
pub(crate) fn description(version: Version, token: &str, start: &Inputs) -> String {
    let mut xml = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Nothing fails in writing to a string.
    let _ = match version {
        Version::Two => two(&mut xml, token, start),
        Version::Three => three(&mut xml, token, start),
    };
    xml
}

const ABOUT: &str = "Wheel-rail contact forces of a wheelset (creepage). Track axes: x forward, y to the right, z \
    down. Outside the map, or where the solver has no answer: Discard.";

fn two(xml: &mut String, token: &str, start: &Inputs) -> std::fmt::Result {
    let tool = concat!("creepage ", env!("CARGO_PKG_VERSION"));
    writeln!(
        xml,
        "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"wheelset\" guid=\"{token}\" \
         description=\"{ABOUT}\" generationTool=\"{tool}\" variableNamingConvention=\"flat\" \
         numberOfEventIndicators=\"0\">"
    )?;
    let can = "canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\" \
               providesDirectionalDerivative=\"true\"";
    writeln!(xml, "<ModelExchange modelIdentifier=\"{IDENTIFIER}\" {can}/>")?;
    writeln!(
        xml,
        "<CoSimulation modelIdentifier=\"{IDENTIFIER}\" \
         canHandleVariableCommunicationStepSize=\"true\" {can}/>"
    )?;
    units(xml)?;
    writeln!(xml, "<TypeDefinitions>")?;
    for (unit, _) in UNITS {
        let name = type_name(unit);
        writeln!(xml, "<SimpleType name=\"{name}\"><Real unit=\"{unit}\"/></SimpleType>")?;
    }
    writeln!(xml, "</TypeDefinitions>")?;
    writeln!(xml, "<LogCategories><Category name=\"logStatusError\"/></LogCategories>")?;
    writeln!(xml, "<DefaultExperiment startTime=\"0\" stopTime=\"1\" stepSize=\"0.001\"/>")?;
    writeln!(xml, "<ModelVariables>")?;
    for (place, (reference, Real { name, unit, causality, meaning })) in numbered().enumerate() {
        let kind = type_name(unit);
        let (as_what, value) = match causality {
            Causality::Output => ("causality=\"output\" initial=\"calculated\"", String::new()),
            Causality::Input => {
                ("causality=\"input\"", format!(" start=\"{:?}\"", start.reals[place]))
            }
        };
        writeln!(
            xml,
            "<ScalarVariable name=\"{name}\" valueReference=\"{reference}\" description=\"{meaning}\" \
             {as_what} variability=\"continuous\"><Real declaredType=\"{kind}\"{value}/></ScalarVariable>"
        )?;
    }
    let switches = (FIRST_SWITCH..).zip(&SWITCHES).zip(start.switches);
    for ((reference, Switch { name, meaning }), value) in switches {
        writeln!(
            xml,
            "<ScalarVariable name=\"{name}\" valueReference=\"{reference}\" description=\"{meaning}\" \
             causality=\"parameter\" variability=\"tunable\"><Boolean start=\"{value}\"/></ScalarVariable>"
        )?;
    }
    writeln!(xml, "</ModelVariables>\n<ModelStructure>")?;
    for list in ["Outputs", "InitialUnknowns"] {
        writeln!(xml, "<{list}>")?;
        for place in INPUTS..REALS.len() {
            writeln!(xml, "<Unknown index=\"{}\"/>", place + 1)?;
        }
        writeln!(xml, "</{list}>")?;
    }
    writeln!(xml, "</ModelStructure>\n</fmiModelDescription>")
}

fn three(xml: &mut String, token: &str, start: &Inputs) -> std::fmt::Result {
    let tool = concat!("creepage ", env!("CARGO_PKG_VERSION"));
    writeln!(
        xml,
        "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"wheelset\" \
         instantiationToken=\"{token}\" description=\"{ABOUT}\" generationTool=\"{tool}\" \
         variableNamingConvention=\"flat\">"
    )?;
    let can = "canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" \
               providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"";
    writeln!(xml, "<ModelExchange modelIdentifier=\"{IDENTIFIER}\" {can}/>")?;
    writeln!(
        xml,
        "<CoSimulation modelIdentifier=\"{IDENTIFIER}\" \
         canHandleVariableCommunicationStepSize=\"true\" {can}/>"
    )?;
    units(xml)?;
    writeln!(xml, "<TypeDefinitions>")?;
    for (unit, _) in UNITS {
        writeln!(xml, "<Float64Type name=\"{}\" unit=\"{unit}\"/>", type_name(unit))?;
    }
    writeln!(xml, "</TypeDefinitions>")?;
    writeln!(xml, "<LogCategories><Category name=\"logStatusError\"/></LogCategories>")?;
    writeln!(xml, "<DefaultExperiment startTime=\"0\" stopTime=\"1\" stepSize=\"0.001\"/>")?;
    writeln!(xml, "<ModelVariables>")?;
    writeln!(
        xml,
        "<Float64 name=\"time\" valueReference=\"0\" causality=\"independent\" \
         variability=\"continuous\" declaredType=\"{}\"/>",
        type_name("s")
    )?;
    for (place, (reference, Real { name, unit, causality, meaning })) in numbered().enumerate() {
        let as_what = match causality {
            Causality::Output => "causality=\"output\" initial=\"calculated\"".to_owned(),
            Causality::Input => format!("causality=\"input\" start=\"{:?}\"", start.reals[place]),
        };
        writeln!(
            xml,
            "<Float64 name=\"{name}\" valueReference=\"{reference}\" description=\"{meaning}\" \
             {as_what} variability=\"continuous\" declaredType=\"{}\"/>",
            type_name(unit)
        )?;
    }
    let switches = (FIRST_SWITCH..).zip(&SWITCHES).zip(start.switches);
    for ((reference, Switch { name, meaning }), value) in switches {
        writeln!(
            xml,
            "<Boolean name=\"{name}\" valueReference=\"{reference}\" description=\"{meaning}\" \
             causality=\"parameter\" variability=\"tunable\" start=\"{value}\"/>"
        )?;
    }
    writeln!(xml, "</ModelVariables>\n<ModelStructure>")?;
    for kind in ["Output", "InitialUnknown"] {
        for (reference, _) in numbered().skip(INPUTS) {
            writeln!(xml, "<{kind} valueReference=\"{reference}\"/>")?;
        }
    }
    writeln!(xml, "</ModelStructure>\n</fmiModelDescription>")
}

/// All numbers with their references.
fn numbered() -> impl Iterator<Item = (u32, &'static Real)> {
    (FIRST_REAL..).zip(&REALS)
}

/// The same in both versions.
fn units(xml: &mut String) -> std::fmt::Result {
    writeln!(xml, "<UnitDefinitions>")?;
    for (name, exponents) in UNITS {
        write!(xml, "<Unit name=\"{name}\"><BaseUnit")?;
        for (unit, exponent) in ["kg", "m", "s", "rad"].into_iter().zip(exponents) {
            if exponent != 0 {
                write!(xml, " {unit}=\"{exponent}\"")?;
            }
        }
        writeln!(xml, "/></Unit>")?;
    }
    writeln!(xml, "</UnitDefinitions>")
}

fn type_name(unit: &str) -> String {
    format!("in_{}", unit.replace('/', "_per_").replace('.', "_"))
}
