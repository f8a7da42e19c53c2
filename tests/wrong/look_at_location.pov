// The camera looks at the place where it stands.
camera { location <0, 1, -5> look_at <0, 1, -5> }
sphere { 0, 1 pigment { rgb 1 } }
