"""Every link of every page leads somewhere, without asking the internet."""

from pathlib import Path

import pytest

from tools.links import ROOT, Link, anchors, links, pages


def test_the_pages_are_all_that_the_project_has() -> None:
    names = {str(page.relative_to(ROOT)) for page in pages()}
    assert {"README.md", "README.ko.md", "CONTRIBUTING.md", "docs/teaching.md", "app/protocols/itsc/README.md"} <= names
    assert not any(".venv" in name or "node_modules" in name for name in names)


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_of_a_page_leads_to_a_file_and_a_heading(page: Path) -> None:
    assert [trouble for link in links(page) if (trouble := link.trouble())] == []


@pytest.mark.parametrize(
    ("target", "trouble"),
    [
        ("two.md", ""),
        ("two.md#a-heading-of-code", ""),
        ("#one", ""),
        ("three.md", "no such file"),
        ("two.md#b", "no heading there has this anchor; there are a-heading-of-code"),
        ("../../elsewhere.md", "leads out of the project"),
        ("more", "is a directory"),
    ],
)
def test_a_link_that_leads_nowhere_is_told_with_its_line(tmp_path: Path, target: str, trouble: str) -> None:
    (tmp_path / "more").mkdir()
    (tmp_path / "two.md").write_text("# A heading: of `code`\n")
    page = tmp_path / "one.md"
    page.write_text(f"# One\n\nsee [this]({target}), and [that](https://example.com/x)\n")
    (link,) = links(page)
    assert link == Link(page, 3, target)
    assert trouble in link.trouble(tmp_path)
    assert bool(trouble) == bool(link.trouble(tmp_path))


def test_equal_headings_have_anchors_of_their_own(tmp_path: Path) -> None:
    page = tmp_path / "one.md"
    page.write_text("# One\n\n## Two\n\n## Two\n")
    assert anchors(page) == {"one", "two", "two-1"}
