# SPDX-License-Identifier: BSD-3-Clause
"""Writes the types of the wrapped module: python3 vtkSSAOPassWritePythonTypes.py vtkSSAOPass.pyi

VTK's wrapping puts the signatures, with types, before the text of each docstring:

    SetRadius(self, radius:float) -> None
    C++: void SetRadius(double radius)

    Distance within which geometry occludes ...
"""

import inspect
import re
import sys

import vtkssaopass.vtkSSAOPass as module

SIGNATURE = re.compile(r"^(\w+)\((.*)\) -> (.+)$")
VTK_CLASS = re.compile(r"\bvtk[A-Z]\w*")


def split_docstring(docstring):
    """The signatures at the head of a docstring, and the text behind them."""
    signatures = []
    text = []
    for line in re.sub(r"\n {4}", " ", docstring or "").splitlines():  # long ones go on indented
        match = SIGNATURE.match(line)
        if match and not text:
            signatures.append((match.group(2), match.group(3)))
        elif signatures and not text and (line.startswith("C++:") or not line):
            continue
        else:
            text.append(line)
    return signatures, "\n".join(text).strip()


def typed(arguments):
    """VTK writes "radius:float=0" and, for arguments that are written to, "[float, float]"."""
    arguments = re.sub(r"(\w):(?=\S)", r"\1: ", arguments)
    return re.sub(r"=[^,)]+", "=...", arguments)


def quoted(text, indent):
    lines = text.replace("\\", "\\\\").replace('"""', "'''").splitlines() or [""]
    body = "\n".join((indent + line).rstrip() for line in lines[1:])
    return f'{indent}"""{lines[0]}' + (f"\n{body}\n{indent}" if body else "") + '"""\n'


def write_method(name, method):
    signatures, text = split_docstring(method.__doc__)
    is_static = isinstance(method, staticmethod) or (signatures and not signatures[0][0].startswith("self"))
    output = ""
    for arguments, result in signatures or [("self, *args: Any", "Any")]:
        if len(signatures) > 1:
            output += "    @overload\n"
        if is_static:
            output += "    @staticmethod\n"
        output += f"    def {name}({typed(arguments)}) -> {result}:\n"
        output += quoted(text, "        ") if text else "        ...\n"
        text = ""  # once is enough
    return output


def property_type(wrapped, value):
    """The docstring of a property says which methods it calls: "read-write, calls GetX/SetX"."""
    getter = re.search(r"\bGet\w+", value.__doc__ or "")
    signatures, _ = split_docstring(getattr(wrapped, getter.group()).__doc__) if getter else ([], "")
    return signatures[0][1] if signatures else "Any"


def write_class(wrapped):
    base = wrapped.__bases__[0]
    output = f"class {wrapped.__name__}({base.__name__}):\n{quoted(wrapped.__doc__.strip(), '    ')}"
    own = {name: value for name, value in vars(wrapped).items() if not name.startswith("__")}
    for name, value in own.items():
        if isinstance(value, type):
            output += f"    class {name}(int): ...\n"
    for name, value in own.items():
        if isinstance(value, int):
            output += f"    {name}: {type(value).__name__}\n"
    for name, value in own.items():
        if inspect.isgetsetdescriptor(value):  # VTK 9.4 and later have them
            output += f"    {name}: {property_type(wrapped, value)}\n"
    for name in own:
        value = getattr(wrapped, name)
        if callable(value) and not isinstance(value, type):
            output += write_method(name, value)
    return output, base


def main():
    classes = ""
    modules = {}
    for _, wrapped in inspect.getmembers(module, inspect.isclass):
        text, base = write_class(wrapped)
        classes += "\n" + text
        modules[base.__name__] = base.__module__
    code = "\n".join(re.findall(r"^ *def .*", classes, re.MULTILINE))
    for name in sorted(set(VTK_CLASS.findall(code))):
        for loaded in list(sys.modules.values()):
            if getattr(loaded, "__name__", "").startswith("vtkmodules.") and hasattr(loaded, name):
                modules.setdefault(name, getattr(loaded, name).__module__)
    imports = "".join(f"from {modules[name]} import {name}\n" for name in sorted(modules))
    with open(sys.argv[1], "w", encoding="utf-8") as output:
        output.write("# Written by vtkSSAOPassWritePythonTypes.py from the docstrings of the wrapping.\n")
        output.write(f"from typing import Any, Callable, overload\n\n{imports}{classes}")


main()
