"""Fills in the reference of files and commands from what the command knows of itself.

    <!-- schema NAME -->   the sections and keys of a file, from `creepage schema --of NAME`
    <!-- help -->          the help of every command
"""

import json
import re
import subprocess

from tables import CREEPAGE, table

def printed(*arguments):
    ran = subprocess.run([CREEPAGE, *arguments], capture_output=True, text=True, check=True)
    return ran.stdout.rstrip()


def sections(name):
    """A heading and a table of keys for each section of a file."""
    schema = json.loads(printed("schema", "--of", name))
    parts = []
    for section, found in schema["properties"].items():
        found = resolved(found, schema)
        needed = "" if section in schema.get("required", []) else ", optional"
        parts.append(f"### `[{section}]`{needed} {{#{name}-{section}}}")
        parts.append(oneline(found.get("description", "")))
        for form in forms(found, schema):
            if form is not found:
                parts.append(oneline(form.get("description", "")))
            parts.append(keys(form, schema))
    return "\n\n".join(part for part in parts if part)


def forms(found, schema):
    """The section itself, or each of the forms that it may have."""
    several = found.get("oneOf") or found.get("anyOf")
    return [resolved(form, schema) for form in several] if several else [found]


def keys(found, schema):
    rows = []
    for key, value in found.get("properties", {}).items():
        value = resolved(value, schema)
        needed = "yes" if key in found.get("required", []) else ""
        rows.append([f"`{key}`", kind(value, schema), needed, oneline(value.get("description", ""))])
    if not rows:
        return ""
    return table(["key", "what", "needed", "meaning"], rows)


def kind(value, schema):
    """What may be written for a key, in a word or two."""
    if "const" in value:
        return f"`\"{value['const']}\"`"
    if "enum" in value:
        return ", ".join(f"`\"{word}\"`" for word in value["enum"] if word is not None)
    for several in ("oneOf", "anyOf"):
        if several in value:
            kinds = [kind(resolved(form, schema), schema) for form in value[several]]
            return " or ".join(dict.fromkeys(one for one in kinds if one != "null"))
    names = value.get("type", "")
    names = [names] if isinstance(names, str) else names
    words = {"number": "number", "integer": "whole number", "string": "text", "array": "list", "object": "table"}
    return " or ".join(words.get(name, name) for name in names if name != "null")


def resolved(value, schema):
    """A schema with its reference followed; what stands beside the reference goes before."""
    while "$ref" in value:
        goal = schema
        for step in value["$ref"].removeprefix("#/").split("/"):
            goal = goal[step]
        value = goal | {key: part for key, part in value.items() if key != "$ref"}
    if "allOf" in value and len(value["allOf"]) == 1:
        value = resolved(value["allOf"][0], schema) | {k: v for k, v in value.items() if k != "allOf"}
    return value


def oneline(text):
    return " ".join(text.split()).replace("|", "\\|")


def commands():
    listed = printed("--help").split("Commands:\n")[1].split("\n\n")[0]
    names = [line.split()[0] for line in listed.splitlines() if re.match(r"  [a-z]", line)]
    parts = [f"```text\n{printed('--help')}\n```"]
    for name in names:
        if name != "help":
            parts.append(f"## creepage {name}\n\n```text\n{printed(name, '--help')}\n```")
    return "\n\n".join(parts)
