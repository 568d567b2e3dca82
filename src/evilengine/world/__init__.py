"""The simulation: bodies, shapes, forces, contacts. Thin typed faces of the core."""
