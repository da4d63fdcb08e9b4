"""Names, roles and passwords as they are given, here and at the command line."""

from typing import Annotated

from pydantic import Field, StringConstraints

from app.api.inputs import ID_PATTERN, TEXT_PATTERN, Strict
from app.api.problems import Problem
from app.domain.access import Role
from app.runtime.passwords import LONGEST, SHORTEST, trouble_with

Name = Annotated[str, StringConstraints(strict=True, min_length=1, max_length=32, pattern=ID_PATTERN)]
Roles = Annotated[list[Annotated[Role, Field(strict=False)]], Field(min_length=1, max_length=len(Role))]
Password = Annotated[
    str,
    Field(min_length=SHORTEST, max_length=LONGEST, pattern=TEXT_PATTERN, json_schema_extra={"format": "password"}),
]


class UserIn(Strict):
    """A person who may log in."""

    name: Name
    roles: Roles
    password: Password


class UserChange(Strict):
    """What to change; a field that is left out stays."""

    roles: Roles | None = None
    disabled: bool | None = None
    password: Password | None = None


class MachineKeyIn(Strict):
    """A machine's key. Without ``days`` it is good until it is revoked."""

    name: Name
    roles: Roles
    days: Annotated[float | None, Field(gt=0, le=3660, allow_inf_nan=False)] = None


def fitting(password: str, name: str, field: str = "password") -> None:
    """Raise Problem if somebody of that name cannot have this password."""
    if trouble := trouble_with(password, name):
        raise Problem("invalid", trouble, "Choose another one.", field)
