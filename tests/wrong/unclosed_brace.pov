// The brace of the sphere is never closed.
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 5, -5> rgb 1 }
sphere {
  <0, 0, 0>, 1
  pigment { rgb <1, 0, 0> }
box { -1, 1 pigment { rgb 1 } }
