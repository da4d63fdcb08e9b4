"""docker-compose.yml, read as a person with a terminal would try it."""

import re
from pathlib import Path
from typing import Any

import typer
import yaml

from app.cli import app as cli
from app.settings import PREFIX, Settings
from app.store.engine import parsed

ROOT = Path(__file__).parents[2]
COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "docker-compose.yml").read_text(encoding="utf-8"))
SERVICES: dict[str, dict[str, Any]] = COMPOSE["services"]


def test_it_has_the_whole_of_a_small_installation() -> None:
    assert set(SERVICES) == {"database", "plant", "controller", "prometheus", "grafana"}


def test_the_commands_are_ones_that_hoistway_takes() -> None:
    commands: Any = typer.main.get_command(cli)
    for name in ("plant", "controller"):
        command, *arguments = SERVICES[name]["command"]
        context = commands.commands[command].make_context(command, arguments)
        assert (ROOT / context.params["plant"]).is_file()


def test_what_is_set_is_a_setting_and_what_is_secret_is_asked_for() -> None:
    for name, value in SERVICES["controller"]["environment"].items():
        assert name.removeprefix(PREFIX).lower() in Settings.model_fields
        if name.endswith("_KEY"):
            assert re.fullmatch(r"\$\{[A-Z_]+:\?.+\}", value)
    assert COMPOSE["secrets"]["metrics_key"]["environment"] in SERVICES["controller"]["environment"]


def test_every_port_is_published_on_this_machine_only() -> None:
    published = [port for service in SERVICES.values() for port in service.get("ports", ())]
    assert published
    assert all(port.startswith("127.0.0.1:") for port in published)


def test_what_is_mounted_is_there_and_volumes_are_declared() -> None:
    for service in SERVICES.values():
        for mount in service.get("volumes", ()):
            source = mount.partition(":")[0]
            if source.startswith("."):
                assert (ROOT / source).exists(), source
                assert mount.endswith(":ro")
            else:
                assert source in COMPOSE["volumes"]


def test_prometheus_scrapes_where_the_controller_is() -> None:
    config = yaml.safe_load((ROOT / "deploy/prometheus/prometheus.yml").read_text(encoding="utf-8"))
    port = SERVICES["plant"]["ports"][0].rpartition(":")[2]
    for job in config["scrape_configs"]:
        assert job["static_configs"] == [{"targets": [f"plant:{port}"]}]
        assert job["authorization"]["credentials_file"] == "/run/secrets/metrics_key"
    assert SERVICES["controller"]["network_mode"] == "service:plant"
    assert SERVICES["prometheus"]["secrets"] == ["metrics_key"]


def test_images_are_pinned_to_a_version() -> None:
    for service in SERVICES.values():
        if "image" in service:
            assert re.fullmatch(r"[a-z/]+:v?\d[\d.]*", service["image"])


def test_the_database_of_the_example_is_one_that_hoistway_takes() -> None:
    url = SERVICES["controller"]["environment"]["HOISTWAY_DATABASE"]
    assert parsed(re.sub(r"\$\{[A-Z_]+:-(\w+)\}", r"\1", url)).drivername == "postgresql+psycopg"
