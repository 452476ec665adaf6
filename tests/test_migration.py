"""The list of modules that must vanish, in scripts/migration.txt."""

from pathlib import Path

from scripts.check_migration import LIST, ROOT, faults, read


def test_the_list_only_shrinks(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("1\n2\n3\n")
    (tmp_path / "b.py").write_text("1\n")
    assert faults({"a.py": 3}, {"a.py": 3, "b.py": 1}, tmp_path) == []
    assert "is new" in faults({"a.py": 3, "b.py": 1}, {"a.py": 3}, tmp_path)[0]
    assert "1 more" in faults({"a.py": 2}, {"a.py": 2}, tmp_path)[0]
    assert "was allowed 2" in faults({"a.py": 3}, {"a.py": 2}, tmp_path)[0]
    assert "is removed" in faults({"c.py": 3}, {"c.py": 3}, tmp_path)[0]


def test_the_modules_have_no_more_lines_than_listed() -> None:
    listed = read((ROOT / LIST).read_text(encoding="utf-8"))
    assert faults(listed, listed, ROOT) == []
