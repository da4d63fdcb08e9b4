"""Compiles the fast plant where numba is installed; without it the same functions run as they stand."""

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any, TypeVar, cast

from app.planning import admission

Function = TypeVar("Function", bound=Callable[..., Any])
COMPILED = find_spec("numba") is not None
"""Whether the fast plant is compiled."""


def _as_it_is(function: Function) -> Function:
    return function


def _compiler() -> Callable[[Any], Any]:
    if not COMPILED:
        return _as_it_is
    from numba import njit
    from numba.extending import register_jitable

    for rule in (admission.comes_back, admission.admits, admission.may_want, admission.leave, admission.enter):
        register_jitable(_nrt=False)(rule)
    # Nothing here makes or keeps an array. Without counting references to the state's fifty, an event takes a twentieth; and
    # a call that is no call need not hand on what is known of each of them: again a third less.
    return cast("Callable[[Any], Any]", cast("Any", njit)(_nrt=False, forceinline=True))


_compile = _compiler()


def compiled(function: Function) -> Function:
    """Return the function compiled when it is first called, or as it is where numba is not installed."""
    return cast("Function", _compile(function))
