"""Where settings come from, and which are refused."""

from pathlib import Path

import pytest

from app.settings import Settings, SettingsError, is_loopback, load

KEY = "0123456789abcdef"


def test_the_environment_goes_before_the_file_and_the_command_line_before_both(tmp_path: Path) -> None:
    file = tmp_path / "hoistway.toml"
    file.write_text('port = 1\ndatabase = "sqlite:///a.db"\nlog_level = "debug"\n')
    settings = load(file, {"HOISTWAY_PORT": "2", "HOISTWAY_DATABASE": "sqlite:///b.db"}, port=3, host=None)
    assert (settings.port, settings.database, settings.log_level) == (3, "sqlite:///b.db", "debug")
    assert settings.host == "127.0.0.1"


def test_the_file_can_be_yaml_and_named_by_the_environment(tmp_path: Path) -> None:
    file = tmp_path / "hoistway.yaml"
    file.write_text("port: 81\nallowed_hosts: [tc.fab]\n")
    assert load(environ={"HOISTWAY_CONFIG": str(file)}).allowed_hosts == ("tc.fab",)
    file.write_text("")
    assert load(file, {}) == Settings()


def test_lists_in_the_environment_are_separated_by_commas() -> None:
    assert load(environ={"HOISTWAY_ALLOWED_HOSTS": "a.fab, b.fab"}).allowed_hosts == ("a.fab", "b.fab")


def test_an_unknown_name_is_refused_with_the_nearest_known_one(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="HOISTWAY_ACESS_KEY is not a setting; did you mean access_key"):
        load(environ={"HOISTWAY_ACESS_KEY": KEY})
    file = tmp_path / "hoistway.toml"
    file.write_text("zzz = 1")
    with pytest.raises(SettingsError, match="'zzz' is not a setting; known are host, port"):
        load(file, {})


def test_the_tests_own_variables_are_not_settings() -> None:
    assert load(environ={"HOISTWAY_TEST_POSTGRES_URL": "x", "PATH": "y"}) == Settings()


def test_a_file_that_cannot_be_read_is_refused_by_name(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match=r"nowhere\.toml cannot be read: No such file or directory$"):
        load(tmp_path / "nowhere.toml", {})
    (tmp_path / "odd.yaml").write_bytes(b"port: \xff")
    with pytest.raises(SettingsError, match=r"odd\.yaml is not UTF-8: invalid start byte at byte 6$"):
        load(tmp_path / "odd.yaml", {})
    file = tmp_path / "list.yaml"
    file.write_text("- 1")
    with pytest.raises(SettingsError, match="expected names and values"):
        load(file, {})


@pytest.mark.parametrize("text", ["port: 2024-99-99", "[" * 5000, "port: [", "port: \x00"])
def test_a_file_that_makes_no_sense_is_refused_by_name(tmp_path: Path, text: str) -> None:
    file = tmp_path / "odd.yaml"
    file.write_text(text)
    with pytest.raises(SettingsError, match=r"odd\.yaml"):
        load(file, {})


def test_an_address_that_others_can_reach_needs_a_key() -> None:
    with pytest.raises(SettingsError, match="set access_key"):
        load(environ={}, host="0.0.0.0")
    assert load(environ={"HOISTWAY_ACCESS_KEY": KEY}, host="0.0.0.0").host == "0.0.0.0"
    with pytest.raises(SettingsError, match="setting access_key"):
        load(environ={"HOISTWAY_ACCESS_KEY": "short"})


def test_a_key_is_not_shown_by_printing_the_settings() -> None:
    assert KEY not in repr(load(environ={"HOISTWAY_ACCESS_KEY": KEY}))


@pytest.mark.parametrize(
    ("host", "loopback"),
    [
        ("localhost", True),
        ("127.0.0.9", True),
        ("::1", True),
        ("[::1]", True),
        ("0.0.0.0", False),
        ("fab.example", False),
    ],
)
def test_loopback_is_known_by_address_and_name(host: str, loopback: bool) -> None:
    assert is_loopback(host) is loopback


def test_where_a_controller_is_called_from_one_can_be_started_too() -> None:
    assert load(environ={"HOISTWAY_URL": "http://tc.fab:8080", "HOISTWAY_KEY": "secret"}) == load(environ={})
    with pytest.raises(SettingsError, match="HOISTWAY_KEYS is not a setting"):
        load(environ={"HOISTWAY_KEYS": "secret"})
