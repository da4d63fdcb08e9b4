"""Settings: environment over file over defaults. Frozen; an unknown name is refused with the nearest known one."""

import difflib
import ipaddress
import math
import os
import tomllib
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Any, Literal

import yaml
from pydantic import AfterValidator, BeforeValidator, Field, SecretStr, ValidationError, model_validator
from pydantic_settings import BaseSettings, PydanticBaseSettingsSource, SettingsConfigDict

from app.domain.errors import HoistwayError
from app.domain.units import Seconds
from app.setting_words import NO_SETTINGS, broken, no_host, no_origin, wrong_in

PREFIX = "HOISTWAY_"
NOT_SETTINGS = ("HOISTWAY_TEST_", "HOISTWAY_CONFIG", "HOISTWAY_LANG")
"""How environment variables of the prefix begin that are not settings: the tests' own, and the one that names the file."""
CALLERS = ("HOISTWAY_URL", "HOISTWAY_KEY")
"""What commands that call a controller take from the environment: they may be set where one is started too."""


MOST_DAYS = 36_500
"""A hundred years: more is a mistake. Our choice."""


def _parts(given: object) -> object:
    """Take a text as a list, as the environment writes it."""
    return tuple(filter(None, (part.strip() for part in given.split(",")))) if isinstance(given, str) else given


def _number(given: object) -> object:
    """Refuse true and false, which count as 1 and 0 else."""
    if isinstance(given, bool):
        raise ValueError(f"{str(given).lower()} is no number")  # noqa: TRY004 (pydantic takes a TypeError for a defect)
    return given


def _host(given: str) -> str:
    if why := no_host(given):
        raise ValueError(why)
    return given


def _origin(given: str) -> str:
    if why := no_origin(given):
        raise ValueError(why)
    return given


Whole = Annotated[int, BeforeValidator(_number)]
Rate = Annotated[float, BeforeValidator(_number), Field(gt=0, allow_inf_nan=False)]


class SettingsError(HoistwayError):
    """The settings cannot be used; the message says which and why."""

    code = "settings"


class Settings(BaseSettings):
    """What differs from one installation to the next. Use :func:`load` to make it."""

    model_config = SettingsConfigDict(frozen=True, env_prefix=PREFIX, extra="forbid", env_ignore_empty=True)

    host: str = "127.0.0.1"
    """Address that the server listens on. Another than loopback needs ``access`` required, or ``access_key``."""
    port: Annotated[Whole, Field(ge=0, le=65535)] = 8080
    """Port that the server listens on; 0: any that is free."""
    database: str = "sqlite:///hoistway.db"
    """SQLAlchemy URL of the database: SQLite or PostgreSQL."""
    plant: Path | None = None
    """The plant file."""
    access_key: Annotated[SecretStr | None, Field(min_length=16)] = None
    """A key that may do everything, shared by all who know it: ``Authorization: Bearer KEY``."""
    metrics_key: Annotated[SecretStr | None, Field(min_length=16)] = None
    """A key that opens ``/metrics`` and nothing else, for Prometheus, where callers have to say who they are."""
    access: Literal["auto", "required"] = "auto"
    """Whether callers have to say who they are: ``auto`` once there is a user or a key, ``required`` always."""
    address_rate: Rate = 1000.0
    """Requests a second from one address, and twice as many at once; this machine's own is not counted."""
    caller_rate: Rate = 2000.0
    """Requests a second by one person's session or one key, and twice as many at once."""
    tls_certificate: Path | None = None
    """A file with the server's certificate and those between it and the root (PEM): then the server speaks TLS."""
    tls_key: Path | None = None
    """A file with the certificate's private key (PEM, no password); by default it is in the certificate's file."""
    allowed_hosts: Annotated[tuple[Annotated[str, AfterValidator(_host)], ...], BeforeValidator(_parts)] = ()
    """Host names, besides loopback's, under which a server without a key may be called (a proxy's name)."""
    allowed_origins: Annotated[tuple[Annotated[str, AfterValidator(_origin)], ...], BeforeValidator(_parts)] = ()
    """Origins, besides the server's own, whose pages may call it (``https://mes.example``)."""
    body_limit: Annotated[Whole, Field(ge=1024)] = 1 << 20
    """Largest request body, bytes."""
    layout_limit: Annotated[Whole, Field(ge=1024)] = 16 << 20
    """Largest plant file that may be staged, bytes."""
    connections: Annotated[Whole, Field(ge=10)] = 2000
    """Most connections to the server at the same time, live streams among them; at most half the files that may be open."""
    watchers: Annotated[Whole, Field(ge=1)] = 1000
    """Most live streams at the same time."""
    history_days: Annotated[Whole, Field(ge=0, le=MOST_DAYS)] = 90
    """Days that events are kept; older ones are deleted. 0: for ever. Jobs, commands and the audit always stay."""
    playback_days: Annotated[float, BeforeValidator(_number), Field(ge=0, le=MOST_DAYS, allow_inf_nan=False)] = 7.0
    """Days that positions and states are kept for playback; older ones are deleted. 0: nothing is recorded."""
    playback_megabytes: Annotated[Whole, Field(ge=10)] = 2000
    """Megabytes that are kept for playback, if the days above are more."""
    webhook_targets: Annotated[tuple[str, ...], BeforeValidator(_parts)] = ()
    """Where webhooks may lead: hosts, ``*.domain``, addresses, networks; by default nowhere (docs/webhooks.md)."""
    webhook_authorities: Path | None = None
    """A file of certificates (PEM) that webhooks trust instead of the system's."""
    log_level: Literal["debug", "info", "warning", "error"] = "info"
    """The least grave lines that are logged."""
    log_format: Literal["console", "json"] = "console"
    """How lines are logged: for people, or for a program."""
    traces: bool = False
    """Whether a trace of each job is sent by OTLP, where OTEL_EXPORTER_OTLP_ENDPOINT says; needs ``hoistway[otel]``."""

    @property
    def keep_events(self) -> Seconds:
        """How long events are kept; infinite for ever."""
        return Seconds(self.history_days * 86_400.0 if self.history_days else math.inf)

    @model_validator(mode="after")
    def _only_loopback_is_open(self) -> "Settings":
        if self.access_key is None and self.access != "required" and not is_loopback(self.host):
            raise ValueError(
                f"host {self.host!r} can be reached from outside: say access: required, set access_key (16 characters or more), "
                "or listen on 127.0.0.1"
            )
        return self

    @model_validator(mode="after")
    def _a_key_belongs_to_a_certificate(self) -> "Settings":
        if self.tls_key is not None and self.tls_certificate is None:
            raise ValueError("tls_key needs tls_certificate")
        return self

    @classmethod
    def settings_customise_sources(
        cls,
        settings_cls: type[BaseSettings],
        init_settings: PydanticBaseSettingsSource,
        env_settings: PydanticBaseSettingsSource,
        dotenv_settings: PydanticBaseSettingsSource,
        file_secret_settings: PydanticBaseSettingsSource,
    ) -> tuple[PydanticBaseSettingsSource, ...]:
        """Leave reading to :func:`load`, which knows where each value came from."""
        return (init_settings,)


@lru_cache(maxsize=256)
def is_loopback(host: str) -> bool:
    """Whether only this machine can reach that address."""
    if host.lower() == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


def load(file: Path | None = None, environ: Mapping[str, str] | None = None, **given: object) -> Settings:
    """Return the settings; ``given`` (what the command line says; None is not said) goes before all else.

    The file is TOML or YAML; without ``file``, the one that HOISTWAY_CONFIG names, if any. Raises: SettingsError.
    """
    environ = os.environ if environ is None else environ
    if file is None and environ.get("HOISTWAY_CONFIG"):
        file = Path(environ["HOISTWAY_CONFIG"])
    written = _read(file) if file else {}
    values = {**written, **_environment(environ), **{k: v for k, v in given.items() if v is not None}}
    try:
        return Settings(**values)
    except ValidationError as error:
        message, remedy = wrong_in(error, Settings)
        raise SettingsError(message, remedy=remedy) from error


def _environment(environ: Mapping[str, str]) -> dict[str, object]:
    found = {
        name.removeprefix(PREFIX).lower(): text
        for name, text in environ.items()
        if name.startswith(PREFIX) and name not in CALLERS and not name.startswith(NOT_SETTINGS) and text
    }
    _refuse_unknown(found, lambda name: f"environment variable {PREFIX}{name.upper()}")
    return dict(found)


def _read(file: Path) -> dict[str, Any]:
    try:
        text = file.read_text(encoding="utf-8")
        values = tomllib.loads(text) if file.suffix == ".toml" else yaml.load(text, Loader=_Strict)  # noqa: S506 (a safe one)
    except OSError as error:
        raise SettingsError(f"settings file {file} cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise SettingsError(f"settings file {file} is not UTF-8: byte {error.start} fits no letter") from error
    except (ValueError, yaml.YAMLError) as error:
        raise SettingsError(f"settings file {file}: {broken(error)}", remedy=NO_SETTINGS) from error
    except RecursionError:
        raise SettingsError(f"settings file {file}: it is nested too deeply") from None
    if values is None:
        return {}
    if not isinstance(values, dict):
        raise SettingsError(f"settings file {file}: expected names and values at the top")
    _refuse_unknown((str(name) for name in values), lambda name: f"settings file {file}: {name!r}")
    return values


class _Strict(yaml.SafeLoader):
    """A loader that refuses a name that is given twice, of which YAML itself keeps the last."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Any, Any]:
        """Return a mapping. Raises yaml.constructor.ConstructorError: a key stands in it twice."""
        seen: set[str] = set()
        for key, _ in node.value:
            if key.value in seen:
                problem = f"{key.value} is given twice"
                raise yaml.constructor.ConstructorError(None, None, problem, key.start_mark)
            seen.add(str(key.value))
        return super().construct_mapping(node, deep)


def _refuse_unknown(names: Iterable[str], where: Any) -> None:
    for name in names:
        if name not in Settings.model_fields:
            near = difflib.get_close_matches(name, Settings.model_fields, n=1)
            hint = f"; did you mean {near[0]}?" if near else f"; known are {', '.join(Settings.model_fields)}"
            raise SettingsError(f"{where(name)} is not a setting{hint}")
