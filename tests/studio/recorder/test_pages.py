from studio.recorder.pages import PACKAGES, package_versions


def test_pages_know_the_versions_of_python_and_of_all_packages():
    assert list(package_versions()) == ["python", *PACKAGES]
