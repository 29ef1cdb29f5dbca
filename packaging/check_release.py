"""Checks the text of the recipes that packaging/make_release has written into a folder."""

import ast
import json
import pathlib
import re
import sys

import yaml

TOP = pathlib.Path(__file__).resolve().parent.parent
VERSION = re.search(r"^project\(.* VERSION (\S+)", (TOP / "CMakeLists.txt").read_text(), re.M)[1]
release = pathlib.Path(sys.argv[1])
wrong = []


def expect(condition, message):
    if not condition:
        wrong.append(message)


def check_versions():
    """Those that no placeholder keeps the same."""
    citation = (TOP / "CITATION.cff").read_text()
    expect(f"\nversion: {VERSION}\n" in citation, f"CITATION.cff: not version {VERSION}")
    changelog = (TOP / "packaging/debian/changelog").read_text()
    expect(f"({VERSION}-" in changelog.split("\n")[0], f"debian/changelog: not version {VERSION}")


def check_placeholders():
    files = [path for name in ("vcpkg", "conan", "conda") for path in (release / name).rglob("*.*")]
    for file in filter(pathlib.Path.is_file, files):
        left = re.findall("@[A-Z0-9]+@", file.read_text())
        expect(not left, f"{file}: {', '.join(left)} are not filled in")


def check_vcpkg():
    port = json.loads((release / "vcpkg/vcpkg.json").read_text())
    known = {"name", "version", "description", "homepage", "license", "dependencies"}
    expect(set(port) == known, f"vcpkg.json has {', '.join(port)}")
    names = [port["name"]] + [d if isinstance(d, str) else d["name"] for d in port["dependencies"]]
    for name in names:
        expect(re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", name), f"vcpkg.json: {name} is no name")
    expect(port["version"] == VERSION, "vcpkg.json has another version")


def check_conan():
    data = yaml.safe_load((release / "conan/conandata.yml").read_text())["sources"][VERSION]
    expect(re.fullmatch("[0-9a-f]{64}", data["sha256"]), "conandata.yml: no checksum")
    wanted = {
        "conanfile.py": {"name", "version", "license", "requirements", "source", "build", "package", "package_info"},
        "test_package/conanfile.py": {"settings", "generators", "requirements", "build", "test"},
    }
    for name, members in wanted.items():
        tree = ast.parse((release / "conan" / name).read_text(), name)
        (recipe,) = [node for node in tree.body if isinstance(node, ast.ClassDef)]
        expect([base.id for base in recipe.bases] == ["ConanFile"], f"{name}: no ConanFile")
        there = {node.name for node in recipe.body if isinstance(node, ast.FunctionDef)}
        for node in recipe.body:
            if isinstance(node, ast.Assign):
                there.update(target.id for target in ast.walk(node) if isinstance(target, ast.Name))
        expect(members <= there, f"{name}: {', '.join(members - there)} are missing")


def check_conda():
    recipe = yaml.safe_load((release / "conda/recipe.yaml").read_text())
    known = {"schema_version", "context", "recipe", "source", "build", "outputs", "about", "extra"}
    expect(set(recipe) == known, f"recipe.yaml has {', '.join(recipe)}")
    expect(recipe["context"]["version"] == VERSION, "recipe.yaml has another version")
    expect(re.fullmatch("[0-9a-f]{64}", recipe["source"]["sha256"]), "recipe.yaml: no checksum")
    for output in recipe["outputs"]:
        name = output["package"]["name"]
        known = {"package", "build", "requirements", "tests"}
        expect(set(output) == known, f"recipe.yaml: {name} has {', '.join(output)}")
        for group, requirements in output["requirements"].items():
            expect(group in ("build", "host", "run"), f"recipe.yaml: {name} requires {group}")
            for text in requirements:
                form = r"\$\{\{ \w+\(\"\w+\"\) \}\}|[a-z0-9-]+( >=[0-9.]+)?"
                expect(re.fullmatch(form, text), f"recipe.yaml: {name} requires {text}")


for check in check_versions, check_placeholders, check_vcpkg, check_conan, check_conda:
    check()
print("\n".join(wrong) or "conan, conda: files can be read, and have what they need")
sys.exit(bool(wrong))
