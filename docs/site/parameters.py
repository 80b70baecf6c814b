# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The page of all parameters, from the structs that hold them."""
from doxygen import Undocumented

# A user meets these; what they are made of follows each. Whatever else is called ...Params comes last.
FIRST = ["MatchParams", "MapperParams", "PaperParams", "LogOptions", "MapLogOptions", "SaveMapOptions"]

HEAD = """# Parameters

Every parameter of the library with its default. The defaults serve every sensor and log that we know: nothing here needs tuning, and `setsquare map` has no option for most of them. `run.json` of a map records the values that made it. Names end with the unit; lengths are in m, angles in rad, times in s, shares from 0 to 1.

In C++ give the fields that differ by their names:

```cpp
#include "setsquare/setsquare.hpp"
#include "setsquare/mapping/mapper_params.hpp"
setsquare::MapperParams params;
params.tracker.keyframe_distance_m = 0.5;
setsquare::Mapper mapper(params);  // throws ParameterError that names a field out of its domain
```

A sentence may go on from one field to the next (...).
"""


def _escaped(text):
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_")


def _section(struct, names):
    lines = [f"\n## {struct.name}\n", f"{_escaped(struct.words)} (`{struct.header}`)\n",
             "| field | default | |", "|---|---|---|"]
    for entry in struct.fields:
        inner = entry.type.removeprefix("std::optional< ").strip(" >")
        value = entry.default.replace("std::numeric_limits<double>::infinity()", "infinity")
        default = f"`{value}`" if value and len(value) < 60 else ""
        if inner in names:
            default = f"[{inner}](#{inner.lower()}) {default}"
        lines.append(f"| `{entry.name}` | {default} | {_escaped(entry.words)} |")
    return "\n".join(lines) + "\n"


def _in_order(structs):
    """Each of FIRST with what it is made of behind it, then the others."""
    ordered = []

    def add(name):
        if name not in structs or name in ordered:
            return
        ordered.append(name)
        for entry in structs[name].fields:
            if entry.type.endswith(("Params", "Options", "Scale", "Trust", "Bounds", "Window", "Slice")):
                add(entry.type)

    for name in FIRST + sorted(name for name in structs if name.endswith("Params")):
        add(name)
    return ordered


def page(structs):
    """The page in Markdown. Raises Undocumented where a field has no words."""
    names = _in_order(structs)
    missing = [f"{name}::{entry.name}" for name in names for entry in structs[name].fields
               if not entry.words]
    if missing:
        raise Undocumented("parameters without words: " + ", ".join(missing))
    return HEAD + "".join(_section(structs[name], names) for name in names)
