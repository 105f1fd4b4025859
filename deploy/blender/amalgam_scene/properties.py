"""The panel's fields. They store nothing themselves: they show and change the custom property "amalgam"."""

import bpy

from . import own_block

# A field without a value shows this; markers count from 0.
NO_MARKER = -1
DEFAULT_DICTIONARY = "DICT_6X6_250"
DEFAULT_LENGTH = 0.05
_LARGEST_MARKER = 1_000_000

_ROLES = (
    ("INHERITED", "As its parent", "The parent's role; virtual if no parent has one"),
    ("virtual", "Virtual", "Is drawn into the camera's picture"),
    ("real", "Real", "A model of something that the camera sees already: it takes shadows and reflections, and hides "
                     "what is behind it"),
)
_ROLE_NAMES = [role[0] for role in _ROLES]

_DICTIONARIES = [f"DICT_{n}X{n}_{size}" for n in (4, 5, 6, 7) for size in (50, 100, 250, 1000)] + [
    "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_16h5", "DICT_APRILTAG_25h9", "DICT_APRILTAG_36h10", "DICT_APRILTAG_36h11"]


def _get_role(thing):
    role = own_block.read(thing).get("role")
    return _ROLE_NAMES.index(role) if role in _ROLE_NAMES else 0


def _set_role(thing, index):
    own_block.write(thing, "role", _ROLE_NAMES[index] if index else None)


def _number(member, otherwise):
    def get(holder):
        value = own_block.read(holder).get(member)
        return value if isinstance(value, (int, float)) else otherwise
    return get


def _marker_field(member, name, description):
    get = _number(member, NO_MARKER)
    return bpy.props.IntProperty(
        name=name, description=description, min=NO_MARKER, max=_LARGEST_MARKER, options=set(),
        get=lambda holder: int(get(holder)),
        set=lambda holder, marker: own_block.write(holder, member, marker if marker >= 0 else None))


def _set_length(scene, length):
    # The field has single precision: 0.05 would be exported as 0.05000000074505806.
    own_block.write(scene, "marker_length", round(length, 6))


def _get_dictionary(scene):
    name = own_block.read(scene).get("dictionary", DEFAULT_DICTIONARY)
    # 0 stands for one that is not in the list: a file of one's own.
    return _DICTIONARIES.index(name) + 1 if name in _DICTIONARIES else 0


def _set_dictionary(scene, index):
    if index:
        own_block.write(scene, "dictionary", _DICTIONARIES[index - 1])


def _get_environment(scene):
    name = own_block.read(scene).get("environment", "")
    return name if isinstance(name, str) else ""


_FIELDS = {
    bpy.types.Object: {
        "amalgam_role": bpy.props.EnumProperty(
            name="Role", description="Whether the camera sees it already", items=_ROLES, options=set(), get=_get_role,
            set=_set_role),
        "amalgam_marker": _marker_field(
            "marker", "Marker", "The marker that it stands on, which lies at Blender's origin; -1: as its parent, or "
            "the world marker"),
    },
    bpy.types.Scene: {
        "amalgam_world_marker": _marker_field(
            "world_marker", "World marker", "The marker at the origin, face up, its right side along +X; -1: not said"),
        "amalgam_marker_length": bpy.props.FloatProperty(
            name="Marker length", description="Width of the markers' black square in metres", min=1e-4, max=100.0,
            precision=4, step=0.1, subtype="DISTANCE", options=set(),
            get=_number("marker_length", DEFAULT_LENGTH), set=_set_length),
        "amalgam_dictionary": bpy.props.EnumProperty(
            name="Dictionary", description="OpenCV's dictionary that the markers are from", options=set(),
            items=[("OTHER", "As typed", "Another one, typed as a custom property")] +
                  [(name, name, "") for name in _DICTIONARIES],
            get=_get_dictionary, set=_set_dictionary),
        "amalgam_environment": bpy.props.StringProperty(
            name="Environment", description="Equirectangular picture of the surroundings (.exr, .hdr, .jpg, .png); it "
            "is copied beside the exported scene", subtype="FILE_PATH", options=set(), get=_get_environment,
            set=lambda scene, path: own_block.write(scene, "environment", path or None)),
    },
}


def register():
    for owner, fields in _FIELDS.items():
        for name, field in fields.items():
            setattr(owner, name, field)


def unregister():
    for owner, fields in _FIELDS.items():
        for name in fields:
            delattr(owner, name)
