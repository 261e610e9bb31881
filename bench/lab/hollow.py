"""A session that shows the opening of its cut."""

import numpy as np

# Shares of the body's diagonal.
REACH = 0.1  # that a hand holds, and that it stays away from the cut
PULL = 0.1  # of each hand
# The view: along the blade, from where it came and from beside it, so that it hides little.
ALONG, BEHIND, BESIDE = 0.75, 0.6, 0.2
NEARER = 0.62  # distance, over that of the session's own view


def unit(vector):
    return vector / np.linalg.norm(vector)


def towards(way, vector):
    """The vector, or against it, that points towards `way`."""
    return vector if way @ vector >= 0 else -vector


def hollow_session(session, points, file, size):
    """The course of `session` up to its first picture while its blade cuts, and the step of that.

    Two hands draw the lips apart meanwhile, which lie together in `session` itself, and one picture
    is taken at the end, from nearer and along the blade. `points` are those of the body at rest.
    None where the session takes no picture during its first stroke, or the body has no skin on
    either side of it.
    """
    poses = [e for e in session["events"] if e["type"] == "blade"][:2]
    ends = [e["step"] for e in session["events"] if e["type"] == "screenshot" and len(poses) == 2
            and poses[0]["step"] < e["step"] < poses[1]["step"]]
    if not ends:
        return None
    middle, later = (np.add(pose["a"], pose["b"]) / 2 for pose in poses)
    along = unit(np.subtract(poses[0]["b"], poses[0]["a"]))
    ahead = unit(later - middle)
    across = unit(np.cross(along, ahead))
    low, high = points.min(axis=0), points.max(axis=0)
    diagonal = np.linalg.norm(high - low)

    lips = [lip_of(points - middle, side * across, along, ahead, REACH * diagonal)
            for side in (1, -1)]
    if None in lips:
        return None
    lips = [points[lip] for lip in lips]
    begin, end = poses[0]["step"], ends[0]
    pulls = [PULL * diagonal * side * across for side in (1, -1)]
    events = [
        *({"step": begin, "type": "grab", "hand": hand, "at": list(lip), "radius": REACH * diagonal}
          for hand, lip in enumerate(lips)),
        poses[0],
        *({"step": end, "type": "drag", "hand": hand, "to": list(lips[hand] + pulls[hand])}
          for hand in (0, 1)),
        {"step": end, "type": "screenshot", "file": file, "width": size[0], "height": size[1]},
        poses[1],
    ]
    target = (lips[0] + lips[1]) / 4 + (low + high) / 4
    arm = np.subtract(session["view"]["eye"], session["view"]["target"])
    way = unit(ALONG * towards(arm, along) - BEHIND * ahead + BESIDE * towards(arm, across))
    eye = target + NEARER * np.linalg.norm(arm) * way
    view = {**session["view"], "eye": list(eye), "target": list(target)}
    return {**session, "events": events, "view": view}, end


def lip_of(ways, outward, along, ahead, gap):
    """The point on one side of the stroke where the blade comes first, at least `gap` beside it."""
    beside = ways @ outward
    late = np.where(beside >= gap, ways @ ahead + beside + abs(ways @ along), np.inf)
    return int(late.argmin()) if np.isfinite(late.min()) else None
