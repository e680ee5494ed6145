# SPDX-License-Identifier: Apache-2.0
"""Which version of an algorithm written in Python a stored run is of: a run of another one must never be taken for it."""

import dis
import functools
import hashlib
import importlib
import io
import pathlib
import pickle
import sys
import sysconfig
import types
from typing import Any

from fairway._core import InputError

_STANDARD = (sysconfig.get_path("stdlib"), sysconfig.get_path("platstdlib"))
_PACKAGES = (sysconfig.get_path("purelib"), sysconfig.get_path("platlib"))
_PLAIN = (type(None), bool, int, float, complex, str, bytes, type(...), type(NotImplemented))
_METHODS = (types.FunctionType, staticmethod, classmethod, property)
_SLOTS = (types.MemberDescriptorType, types.GetSetDescriptorType)


class _Unreadable(Exception):
    """Something whose value cannot be written down."""


def _file_of(module: str | None) -> str | None:
    return getattr(sys.modules.get(module or ""), "__file__", None)


def _bytes_of(file: str) -> bytes:
    return hashlib.sha256(pathlib.Path(file).read_bytes()).digest()


class _Pickler(pickle.Pickler):
    """Writes functions and classes of the user's down by what they are: pickle itself writes their names."""

    def __init__(self, file: io.BytesIO, digest: "_Digest") -> None:
        super().__init__(file, protocol=4)
        self._digest = digest

    def persistent_id(self, thing: Any) -> str | None:
        if isinstance(thing, (types.FunctionType, type)) and not self._digest.is_installed(thing.__module__):
            self._digest.add(thing)
            return "the user's"
        return None


class _Digest:
    """Of all that decisions can come of: code, what it refers to by name, defaults, attributes, closures."""

    def __init__(self, package: str) -> None:
        self._package = package
        self._hash = hashlib.sha256()
        self._seen: dict[int, tuple[int, object]] = {}  # with what it is, so that no other takes its place

    def is_installed(self, module: str | None) -> bool:
        """Of Python, of fairway or of a package: its version stands for it. Otherwise it is the user's, as is the package
        that the algorithm itself is in, wherever it stands."""
        top = (module or "builtins").split(".")[0]
        if top == self._package:
            return False
        if top in ("fairway", "builtins"):
            return True
        file = _file_of(module)
        if file is None:
            return top != "__main__"
        return file.startswith(_STANDARD + _PACKAGES) or "site-packages" in file or "dist-packages" in file

    def hex(self) -> str:
        return self._hash.hexdigest()

    def _say(self, *words: object) -> None:
        self._hash.update(repr(words).encode("utf-8", "surrogatepass"))

    def add(self, thing: Any) -> None:
        if isinstance(thing, _PLAIN):
            self._say(type(thing).__name__, thing)
            return
        if id(thing) in self._seen:
            self._say("again", self._seen[id(thing)][0])
            return
        self._seen[id(thing)] = (len(self._seen), thing)
        self._say(type(thing).__qualname__)
        self._compiled(getattr(thing, "__module__", None))
        if isinstance(thing, (tuple, list)):
            self._all(thing)
        elif isinstance(thing, (set, frozenset)):
            self._all(sorted(thing, key=repr))
        elif isinstance(thing, (dict, types.MappingProxyType)):
            self._all([part for item in thing.items() for part in item])
        elif isinstance(thing, types.CodeType):
            self._code(thing)
        elif isinstance(thing, types.FunctionType):
            self._function(thing)
        elif isinstance(thing, types.MethodType):
            self._all([thing.__func__, thing.__self__])
        elif isinstance(thing, types.ModuleType):
            self._module(thing)
        elif isinstance(thing, type):
            self._class(thing)
        else:
            self._object(thing)

    def _all(self, things: Any) -> None:
        self._say(len(things))
        for thing in things:
            self.add(thing)

    def _code(self, code: types.CodeType) -> None:
        self._say(code.co_code, code.co_names, code.co_varnames, code.co_freevars, code.co_flags)
        self._all(code.co_consts)

    def _function(self, function: types.FunctionType) -> None:
        if self._by_version(function):
            return
        self.add(function.__code__)
        self._all([function.__defaults__, function.__kwdefaults__])
        self._all([cell.cell_contents for cell in function.__closure__ or ()])
        used, imported = _names_in(function.__code__)
        for name in sorted(used & function.__globals__.keys()):
            self._say(name)
            self.add(function.__globals__[name])
        for name in sorted(imported):
            try:
                self.add(importlib.import_module(name))
            except ImportError as error:
                raise _Unreadable(f"the module {name}") from error

    def _module(self, module: types.ModuleType) -> None:
        """One of the user's is all that stands in it: which part of it is used cannot be told."""
        if self.is_installed(module.__name__):
            self._installed(module.__name__, module.__name__)
            return
        self._compiled(module.__name__)
        for name, value in vars(module).items():
            if not name.startswith("__"):
                self._say(name)
                self.add(value)

    def _class(self, kind: type) -> None:
        if self._by_version(kind):
            return
        self._all(kind.__bases__)
        for name, value in vars(kind).items():
            # what Python itself notes in a class says nothing that its methods and attributes do not
            noted = name == "_abc_impl" or (name.startswith("__") and not isinstance(value, _METHODS))
            if not noted and not isinstance(value, _SLOTS):
                self._say(name)
                self.add(value)

    def _object(self, thing: Any) -> None:
        if isinstance(thing, (staticmethod, classmethod)):
            self.add(thing.__func__)
        elif isinstance(thing, property):
            self._all([thing.fget, thing.fset])
        elif isinstance(thing, functools.partial):
            self._all([thing.func, thing.args, thing.keywords])
        elif hasattr(thing, "__wrapped__"):
            self.add(thing.__wrapped__)
        elif isinstance(thing, (types.BuiltinFunctionType, types.MethodDescriptorType, types.WrapperDescriptorType)):
            self._say(thing.__qualname__)
        elif hasattr(thing, "__dict__") and not self.is_installed(type(thing).__module__):
            self._all([type(thing), vars(thing)])
        else:
            try:
                written = io.BytesIO()
                _Pickler(written, self).dump(thing)
                self._say(written.getvalue())
            except _Unreadable:
                raise
            except Exception as error:
                raise _Unreadable(repr(thing)) from error

    def _by_version(self, thing: Any) -> bool:
        module = getattr(thing, "__module__", None) or "builtins"
        if self.is_installed(module):
            self._installed(module, thing.__qualname__)
            return True
        return False

    def _installed(self, module: str, name: str) -> None:
        version = getattr(sys.modules.get(module.split(".")[0]), "__version__", None)
        file = _file_of(module)
        if version is None and file is not None and not file.startswith(_STANDARD):
            version = _bytes_of(file)
        self._say(module, name, version or sys.version_info[:2])

    def _compiled(self, module: str | None) -> None:
        """A module of the user's that is not written in Python is its file."""
        file = _file_of(module)
        if file is not None and not file.endswith(".py") and not self.is_installed(module):
            self._say(module, _bytes_of(file))


def _names_in(code: types.CodeType) -> tuple[set[str], set[str]]:
    """Of globals and of modules that it imports, in it and in all functions inside."""
    steps = list(dis.get_instructions(code))
    used = {step.argval for step in steps if step.opname in ("LOAD_GLOBAL", "LOAD_NAME")}
    imported = {step.argval for step in steps if step.opname == "IMPORT_NAME"}
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            more_used, more_imported = _names_in(constant)
            used |= more_used
            imported |= more_imported
    return used, imported


def version_of(name: str, algorithm: Any) -> str:
    """The attribute `version` of a class or factory, or a digest of all that it is made of. Raises InputError for what
    has neither."""
    said = getattr(algorithm, "version", None)
    if said is not None and not callable(said):
        return f"version {said}"
    digest = _Digest((getattr(algorithm, "__module__", None) or type(algorithm).__module__).split(".")[0])
    try:
        digest.add(algorithm)
    except _Unreadable as unreadable:
        raise InputError(
            f'the algorithm "{name}" uses {str(unreadable)[:80]}, of which nobody can tell whether it has changed, so '
            f'stored runs could go stale: give it an attribute version = "1", and raise it with every change'
        ) from None
    except (RecursionError, ValueError) as error:
        raise InputError(
            f'the algorithm "{name}" cannot be read to its end ({type(error).__name__}), so stored runs could go '
            f'stale: give it an attribute version = "1", and raise it with every change'
        ) from None
    return f"digest {digest.hex()}"
