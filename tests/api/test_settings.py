"""Where settings come from, and which are refused."""

from pathlib import Path

import pytest

from app.setting_words import EXAMPLES, NO_SETTINGS, described
from app.settings import Settings, SettingsError, is_loopback, load
from app.texts import said

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
    with pytest.raises(SettingsError, match=r"odd\.yaml is not UTF-8: byte 6 fits no letter$"):
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


@pytest.mark.parametrize(
    ("name", "given", "reason"),
    [
        ("allowed_hosts", "[", "'[' is no name of a host"),
        ("allowed_hosts", "https://tc.fab", "is no name of a host: no scheme, port, path or * belongs to it"),
        ("allowed_hosts", "tc.fab:8080", "is no name of a host"),
        ("allowed_hosts", "*.fab", "is no name of a host"),
        ("allowed_hosts", 3, "3 is no list"),
        ("allowed_origins", "mes.fab", "'mes.fab' is no origin"),
        ("allowed_origins", "https://mes.fab/page", "is no origin"),
        ("allowed_origins", "https://", "is no origin"),
        ("allowed_origins", "ftp://mes.fab", "is no origin"),
        ("allowed_origins", "https://mes.fab:99999", "is no origin"),
        ("allowed_origins", "https://me@mes.fab", "is no origin"),
        ("allowed_origins", "*", "is no origin"),
        ("address_rate", "inf", "'inf' is no finite number"),
        ("address_rate", "nan", "'nan' is no finite number"),
        ("address_rate", True, "true is no number"),
        ("caller_rate", 0, "0 is not above 0"),
        ("caller_rate", "fast", "'fast' is no number"),
        ("playback_days", float("inf"), "inf is no finite number"),
        ("playback_days", -1, "-1 is not at least 0"),
        ("playback_days", 1e9, "is not at most 36500"),
        ("history_days", "1.5", "'1.5' is no whole number"),
        ("port", 70_000, "70000 is not at most 65535"),
        ("port", True, "true is no number"),
        ("connections", 1, "1 is not at least 10"),
        ("log_level", "loud", "'loud' is none of 'debug', 'info', 'warning', 'error'"),
        ("traces", "maybe", "'maybe' is neither true nor false"),
        ("plant", 7, "7 is no name of a file"),
        ("access_key", "short", "needs 16 characters or more, and has 5"),
    ],
)
def test_a_value_that_makes_no_sense_is_refused_with_what_the_setting_is(name: str, given: object, reason: str) -> None:
    with pytest.raises(SettingsError) as refused:
        load(None, {}, **{name: given})
    assert refused.value.message.startswith(f"setting {name}: ")
    assert reason in refused.value.message
    assert refused.value.remedy.startswith(f"{name} is: {described(Settings)[name]} Example: ")
    assert said(refused.value.message, "ko").startswith(f"설정 {name}: ")
    assert said(refused.value.remedy, "ko").startswith(f"{name} 설명: ")


def test_a_key_that_is_refused_is_not_repeated() -> None:
    for key in ("hunter2-hunter2"[:15], ["hunter2-hunter2-hunter2"]):
        with pytest.raises(SettingsError) as refused:
            load(environ={}, access_key=key)
        assert "hunter2" not in refused.value.message + refused.value.remedy


def test_every_setting_says_what_it_is_in_both_languages_and_its_example_is_taken() -> None:
    told = described(Settings)
    assert set(told) == set(Settings.model_fields)
    assert [text for text in told.values() if said(text, "ko") == text] == []
    for name, example in EXAMPLES.items():
        more = {"tls_certificate": "x.pem"} if name == "tls_key" else {}
        assert getattr(load(None, {}, **more, **{name: example}), name), name


@pytest.mark.parametrize("host", ["tc.fab", "TC", "10.0.0.7", "[fd00::7]", "fd00::7", "tc_1.fab.example."])
@pytest.mark.parametrize(
    "origin", ["https://mes.fab", "http://10.0.0.7:8443", "https://[fd00::7]:1", "HTTPS://MES.fab/"]
)
def test_names_of_hosts_and_origins_are_taken_as_people_and_browsers_write_them(host: str, origin: str) -> None:
    settings = load(environ={}, allowed_hosts=[host], allowed_origins=f"{origin}, ")
    assert (settings.allowed_hosts, settings.allowed_origins) == ((host,), (origin,))


@pytest.mark.parametrize(
    ("name", "text", "where"),
    [
        ("s.yaml", "port: 1\nport: 2\n", "line 2, column 1: port is given twice"),
        ("s.yaml", "port: [", "line 1, column 8: a value is expected here"),
        ("s.yaml", "port: [1", "a comma is missing here, or a bracket is not closed"),
        ("s.toml", "port = 1\nport = 2\n", "line 2, column 9: this is no TOML"),
        ("s.toml", "port = ", "is no TOML|ends in the middle"),
    ],
)
def test_a_file_that_breaks_its_grammar_says_where(tmp_path: Path, name: str, text: str, where: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(SettingsError, match=where) as refused:
        load(tmp_path / name, {})
    assert refused.value.remedy == NO_SETTINGS
    assert said(refused.value.message, "ko").startswith("설정 파일")


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
