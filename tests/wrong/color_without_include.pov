// A colour's name, but colors.inc is not included.
light_source { <5, 5, -5> White }
