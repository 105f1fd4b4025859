"""Scenes for Amalgam: roles, markers and light of a scene in the 3D view's side bar, and their export as glTF.

What is said here is kept in custom properties of the name "amalgam", which Blender saves with its file and its own
glTF exporter writes as "extras". The file is as good without this add-on.
"""

import importlib

bl_info = {
    "name": "Amalgam scenes",
    "author": "Amalgam",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Amalgam; File > Export > Amalgam scene",
    "description": "Real and virtual objects on markers, exported as glTF for the Amalgam server",
    "category": "Import-Export",
}

_ROOMS = [importlib.import_module(f".{name}", __name__)
          for name in ("properties", "materials", "guide", "problems", "export", "panels")]


def register():
    for room in _ROOMS:
        room.register()


def unregister():
    for room in reversed(_ROOMS):
        room.unregister()
