"""Fields with places, a folder a kind: ring, names, elements, places, residues; symbols, conics, completions.

A ring names the class of :class:`hfield.structure.global_field.GlobalField` that knows its kind.
"""
