// The pigment's brace is missing; the object's closes it instead.
sphere {
  <0, 0, 0>, 1
  pigment { rgb <1, 0, 0>
  finish { phong 0.5 }
}
plane { y, 0 }
