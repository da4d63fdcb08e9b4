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
from pydantic import Field, SecretStr, ValidationError, model_validator
from pydantic_settings import BaseSettings, PydanticBaseSettingsSource, SettingsConfigDict

from app.domain.errors import HoistwayError
from app.domain.units import Seconds

PREFIX = "HOISTWAY_"
NOT_SETTINGS = ("HOISTWAY_TEST_", "HOISTWAY_CONFIG", "HOISTWAY_LANG")
"""How environment variables of the prefix begin that are not settings: the tests' own, and the one that names the file."""
CALLERS = ("HOISTWAY_URL", "HOISTWAY_KEY")
"""What commands that call a controller take from the environment: they may be set where one is started too."""


class SettingsError(HoistwayError):
    """The settings cannot be used; the message says which and why."""

    code = "settings"


class Settings(BaseSettings):
    """What differs from one installation to the next. Use :func:`load` to make it."""

    model_config = SettingsConfigDict(frozen=True, env_prefix=PREFIX, extra="forbid", env_ignore_empty=True)

    host: str = "127.0.0.1"
    """Address that the server listens on. Another than loopback needs ``access`` required, or ``access_key``."""
    port: Annotated[int, Field(ge=0, le=65535)] = 8080
    database: str = "sqlite:///hoistway.db"
    """SQLAlchemy URL."""
    plant: Path | None = None
    """The plant file."""
    access_key: Annotated[SecretStr | None, Field(min_length=16)] = None
    """A key that may do everything, shared by all who know it: ``Authorization: Bearer KEY``."""
    metrics_key: Annotated[SecretStr | None, Field(min_length=16)] = None
    """A key that opens ``/metrics`` and nothing else, for Prometheus, where callers have to say who they are."""
    access: Literal["auto", "required"] = "auto"
    """Whether callers have to say who they are: ``auto`` once there is a user or a key, ``required`` always."""
    address_rate: Annotated[float, Field(gt=0)] = 1000.0
    """Requests a second from one address, and twice as many at once; this machine's own is not counted."""
    caller_rate: Annotated[float, Field(gt=0)] = 2000.0
    """Requests a second by one person's session or one key, and twice as many at once."""
    tls_certificate: Path | None = None
    """A file with the server's certificate and those between it and the root (PEM): then the server speaks TLS."""
    tls_key: Path | None = None
    """A file with the certificate's private key (PEM, no password); by default it is in the certificate's file."""
    allowed_hosts: tuple[str, ...] = ()
    """Host names, besides loopback's, under which a server without a key may be called (a proxy's name)."""
    allowed_origins: tuple[str, ...] = ()
    """Origins, besides the server's own, whose pages may call it (``https://mes.example``)."""
    body_limit: Annotated[int, Field(ge=1024)] = 1 << 20
    """Largest request body, bytes."""
    layout_limit: Annotated[int, Field(ge=1024)] = 16 << 20
    """Largest plant file that may be staged, bytes."""
    connections: Annotated[int, Field(ge=10)] = 2000
    """Most connections to the server at the same time, live streams among them; at most half the files that may be open."""
    watchers: Annotated[int, Field(ge=1)] = 1000
    """Most live streams at the same time."""
    history_days: Annotated[int, Field(ge=0, le=36_500)] = 90
    """Days that events are kept; older ones are deleted. 0: for ever. Jobs, commands and the audit always stay."""
    playback_days: Annotated[float, Field(ge=0)] = 7.0
    """Days that positions and states are kept for playback; older ones are deleted. 0: nothing is recorded."""
    playback_megabytes: Annotated[int, Field(ge=10)] = 2000
    """And so much at most, whichever is less."""
    webhook_targets: tuple[str, ...] = ()
    """Where webhooks may lead: hosts, ``*.domain``, addresses, networks; by default nowhere (docs/webhooks.md)."""
    webhook_authorities: Path | None = None
    """A file of certificates (PEM) that webhooks trust instead of the system's."""
    log_level: Literal["debug", "info", "warning", "error"] = "info"
    log_format: Literal["console", "json"] = "console"
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
        raise SettingsError(_sentence(error)) from error


def _environment(environ: Mapping[str, str]) -> dict[str, object]:
    found = {
        name.removeprefix(PREFIX).lower(): text
        for name, text in environ.items()
        if name.startswith(PREFIX) and name not in CALLERS and not name.startswith(NOT_SETTINGS) and text
    }
    _refuse_unknown(found, lambda name: f"environment variable {PREFIX}{name.upper()}")
    lists = {"allowed_hosts", "allowed_origins", "webhook_targets"}
    return {
        name: tuple(part.strip() for part in text.split(",")) if name in lists else text for name, text in found.items()
    }


def _read(file: Path) -> dict[str, Any]:
    try:
        text = file.read_text(encoding="utf-8")
        values = tomllib.loads(text) if file.suffix == ".toml" else yaml.safe_load(text)
    except OSError as error:
        raise SettingsError(f"settings file {file} cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise SettingsError(f"settings file {file} is not UTF-8: {error.reason} at byte {error.start}") from error
    except (ValueError, yaml.YAMLError) as error:
        raise SettingsError(f"settings file {file}: {error}") from error
    except RecursionError:
        raise SettingsError(f"settings file {file}: it is nested too deeply") from None
    if values is None:
        return {}
    if not isinstance(values, dict):
        raise SettingsError(f"settings file {file}: expected names and values at the top")
    _refuse_unknown((str(name) for name in values), lambda name: f"settings file {file}: {name!r}")
    return values


def _refuse_unknown(names: Iterable[str], where: Any) -> None:
    for name in names:
        if name not in Settings.model_fields:
            near = difflib.get_close_matches(name, Settings.model_fields, n=1)
            hint = f"; did you mean {near[0]}?" if near else f"; known are {', '.join(Settings.model_fields)}"
            raise SettingsError(f"{where(name)} is not a setting{hint}")


def _sentence(error: ValidationError) -> str:
    first = error.errors(include_url=False, include_input=False)[0]
    name = ".".join(str(part) for part in first["loc"])
    message = first["msg"].removeprefix("Value error, ")
    if first["type"] == "too_short":
        message = f"needs {first['ctx']['min_length']} characters or more, and has {first['ctx']['actual_length']}"
    return f"setting {name}: {message}" if name else message
