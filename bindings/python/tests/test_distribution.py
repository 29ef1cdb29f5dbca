"""What is installed beside the package, if it was installed."""

import importlib.metadata

import pytest

import approximate_geodesics as ag


def distribution():
    try:
        return importlib.metadata.distribution("approximate-geodesics")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("the package was built, and not installed")


def test_license_is_there():
    (text,) = [file.read_text() for file in distribution().files if file.name == "LICENSE"]
    assert "GNU GENERAL PUBLIC LICENSE" in text


def test_metadata_tell_license_and_authors():
    metadata = distribution().metadata
    assert metadata["License"] == "GPL-3.0-or-later"
    assert metadata["Author"] == "The Approximate Geodesics authors"
    assert metadata["Summary"].startswith("Geodesic distances and paths on triangle meshes")
    assert "geodesic distance" in metadata["Keywords"].split(",")
    assert any("GPLv3+" in classifier for classifier in metadata.get_all("Classifier"))


def test_version_is_that_of_the_metadata():
    assert ag.__version__ == distribution().version
