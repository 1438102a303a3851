"""Names in a recording: what its entities are called."""

import rerun as rr


def entity_part(name: str) -> str:
    """A name as one part of an entity path, whatever characters it has."""
    return rr.escape_entity_path_part(name)
