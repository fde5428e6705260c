"""The reference of the Python package, from its own sources."""

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python" / "creepage"
BLANK = ast.parse("")
# What the guide groups, in a reader's order; the rest of what the package exports comes last.
GROUPS = {
    "Cases in SI units": ["Case", "Body", "Solution", "SiCreepage", "DimensionlessCreepage", "SiForce", "Curve", "Hertz", "hertz"],
    "Theories": [
        "theory", "Theory", "DifferentiableTheory", "Exact", "Automatic", "Variational", "Fastrip", "Fastsim", "Strip",
        "Polach", "ShenHedrickElkins", "VermeulenJohnson", "Linear", "Saturated", "coefficients",
    ],
    "Answers": [
        "Force", "ForceArray", "ScalarForce", "ExactForce", "ExactForceArray", "ScalarExactForce", "Field", "ElementField",
        "Found", "Region", "Status", "CreepageCoefficients",
    ],
    "Many cases": ["batch", "sweep", "Table"],
    "Any shape, wheelsets, unsteady rolling": [
        "Gap", "GapCase", "GapSolution", "AreaContact", "Estimate", "Wheelset", "WheelsetSolution", "Wheel", "RailForce",
        "WheelContact", "Rolling", "RollingStep", "roll",
    ],
    "Other contacts": ["statics", "StaticsSolution", "carter", "CarterSolution", "line_contact", "LineContact"],
}


def reference():
    known = definitions()
    exported = [name for name in exports() if name in known]
    for name in exported:
        inherit(known[name], known, exported)
    grouped = {name for names in GROUPS.values() for name in names}
    groups = GROUPS | {"Errors and the rest": [name for name in exported if name not in grouped]}
    parts = []
    for title, names in groups.items():
        parts.append(f"## {title}")
        parts += [shown(name, known[name]) for name in names if name in exported]
    return "\n\n".join(parts)


def exports():
    """What the package's own list names."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text(encoding="utf-8"))
    for node in tree.body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return ast.literal_eval(node.value)
    return []


def definitions():
    """Classes and functions by name, of the compiled part's stubs and of all modules; the first with words."""
    known = {}
    for path in [PACKAGE / "_creepage.pyi", *sorted(PACKAGE.glob("*.py"))]:
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef | ast.FunctionDef) and not ast.get_docstring(known.get(node.name, BLANK)):
                known[node.name] = node
    return known


def inherit(node, known, exported):
    """What a class has of bases that the package does not show, and these of theirs, becomes its own."""
    bases = list(getattr(node, "bases", []))
    for base in bases:
        hidden = ast.unparse(base)
        if hidden in known and hidden not in exported:
            if base in node.bases:
                node.bases.remove(base)
            node.body += known[hidden].body
            bases += known[hidden].bases


def shown(name, node):
    parts = [f"### `{name}` {{#{name}}}"]
    if isinstance(node, ast.FunctionDef):
        return "\n\n".join([*parts, signature(node), words(node)])
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    parts += [f"*class, a {bases}*" if bases else "*class*", words(node), fields(node)]
    parts += methods(node)
    return "\n\n".join(part for part in parts if part)


def fields(node):
    """Annotated fields with the text that follows each, and properties."""
    rows = []
    for field, after in zip(node.body, [*node.body[1:], None]):
        if isinstance(field, ast.AnnAssign) and not field.target.id.startswith("_"):
            text = after.value.value if is_text(after) else ""
            rows.append((field.target.id, ast.unparse(field.annotation), text))
        if isinstance(field, ast.FunctionDef) and "property" in map(ast.unparse, field.decorator_list):
            kind = ast.unparse(field.returns) if field.returns else ""
            rows.append((field.name, kind, ast.get_docstring(field) or ""))
    lines = [f"- `{name}`: `{kind}`. {oneline(text)}" for name, kind, text in rows]
    return "\n".join(lines)


def is_text(node):
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def methods(node):
    """Each method once: of several signatures the one with words."""
    found = {}
    for method in node.body:
        hidden = not isinstance(method, ast.FunctionDef) or "property" in map(ast.unparse, method.decorator_list)
        if hidden or (method.name.startswith("_") and method.name not in ("__init__", "__new__")):
            continue
        if method.name not in found or ast.get_docstring(method):
            found[method.name] = method
    for method in found.values():
        yield f"**`{method.name}`**\n\n{signature(method)}"
        yield words(method)


def signature(node):
    arguments = ast.unparse(node.args)
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    text = f"{node.name}({arguments}){returns}"
    if len(text) > 90:
        text = re.sub(r", (?=\*?\w+(:|=|$|,))", ",\n    ", text)
    return f"```py\n{text}\n```"


def words(node):
    """The documentation; what a colon announces and is indented is code."""
    text = ast.get_docstring(node) or ""
    return re.sub(r"::$", ":", text, flags=re.MULTILINE)


def oneline(text):
    return " ".join(text.split())
