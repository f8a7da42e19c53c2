// A mesh without inside_vector has no inside to cut with.
difference {
  box { -1, 1 }
  mesh { triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } }
  pigment { rgb 1 }
}
