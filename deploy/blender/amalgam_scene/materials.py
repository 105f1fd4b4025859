"""Mirrors and glass: what Amalgam makes of a material, and operators that make the two."""

import bpy

# The exporter takes glass for solid if the material has a node group of this name with a thickness above 0. It is the
# exporter's own group, which only its preferences offer.
_OUTPUT_GROUP = "glTF Material Output"
# Blender 4 renamed the input.
_TRANSMISSION = ("Transmission Weight", "Transmission")

# As server/scene/gltf/materials.cpp decides.
_TRANSMISSIVE, _METALLIC, _SMOOTH = 0.5, 0.5, 0.2


def _principled(material):
    if not material or not material.node_tree:
        return None
    return next((n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"), None)


def _input(node, *names):
    return next(node.inputs[name] for name in names if name in node.inputs)


def _thickness(material):
    for node in material.node_tree.nodes:
        if node.type == "GROUP" and node.node_tree and node.node_tree.name.startswith(_OUTPUT_GROUP):
            socket = node.inputs.get("Thickness")
            if socket:
                return socket
    return None


def kind_of(material):
    """diffuse, mirror, solid glass or thin glass."""
    node = _principled(material)
    if not node:
        return "diffuse"
    if _input(node, *_TRANSMISSION).default_value >= _TRANSMISSIVE:
        thickness = _thickness(material)
        is_solid = thickness and (thickness.is_linked or thickness.default_value > 0)
        return "solid glass" if is_solid else "thin glass"
    is_mirror = _input(node, "Metallic").default_value >= _METALLIC and \
        _input(node, "Roughness").default_value <= _SMOOTH
    return "mirror" if is_mirror else "diffuse"


def _output_group():
    tree = bpy.data.node_groups.get(_OUTPUT_GROUP) or bpy.data.node_groups.new(_OUTPUT_GROUP, "ShaderNodeTree")
    has_interface = hasattr(tree, "interface")  # Blender 4
    names = [item.name for item in (tree.interface.items_tree if has_interface else tree.inputs)]
    for name in ("Occlusion", "Thickness"):
        if name in names:
            continue
        if has_interface:
            tree.interface.new_socket(name, in_out="INPUT", socket_type="NodeSocketFloat")
        else:
            tree.inputs.new("NodeSocketFloat", name)
    if not any(node.type == "GROUP_INPUT" for node in tree.nodes):
        tree.nodes.new("NodeGroupInput")
    return tree


def make_solid(material):
    socket = _thickness(material)
    if not socket:
        group = material.node_tree.nodes.new("ShaderNodeGroup")
        group.node_tree = _output_group()
        group.label, group.location = _OUTPUT_GROUP, (40, -320)
        socket = group.inputs["Thickness"]
    # Any value: rays find the true thickness themselves.
    if socket.default_value <= 0:
        socket.default_value = 1.0


class _MaterialOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def execute(self, context):
        material = self._own_material(context.object)
        node = _principled(material)
        if not node:
            self.report({"ERROR"}, f"{material.name} has no Principled BSDF")
            return {"CANCELLED"}
        self.change(material, node)
        return {"FINISHED"}

    def _own_material(self, thing):
        if not thing.active_material:
            thing.active_material = bpy.data.materials.new(self.bl_label)
        thing.active_material.use_nodes = True
        return thing.active_material


class AMALGAM_OT_glass(_MaterialOperator, bpy.types.Operator):
    """Make the active material clear, solid glass"""

    bl_idname = "amalgam.glass"
    bl_label = "Solid glass"

    def change(self, material, node):
        _input(node, *_TRANSMISSION).default_value = 1.0
        _input(node, "Metallic").default_value = 0.0
        _input(node, "Roughness").default_value = 0.0
        _input(node, "Base Color").default_value = (1, 1, 1, 1)
        _input(node, "IOR").default_value = 1.5
        make_solid(material)


class AMALGAM_OT_mirror(_MaterialOperator, bpy.types.Operator):
    """Make the active material a mirror of its base color"""

    bl_idname = "amalgam.mirror"
    bl_label = "Mirror"

    def change(self, material, node):
        _input(node, *_TRANSMISSION).default_value = 0.0
        _input(node, "Metallic").default_value = 1.0
        _input(node, "Roughness").default_value = 0.0


_CLASSES = (AMALGAM_OT_glass, AMALGAM_OT_mirror)


def register():
    for made in _CLASSES:
        bpy.utils.register_class(made)


def unregister():
    for made in _CLASSES:
        bpy.utils.unregister_class(made)
