// blob: cylinders and transformed components, in a difference.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

difference {
  blob {
    threshold 0.4
    cylinder { -1.5 * x, 1.5 * x, 0.7, 1 }
    cylinder { <-1, -1, 0>, <-1, 1, 0>, 0.6, 1 rotate 10 * z }
    sphere { 0, 1, 1.2 scale <0.6, 1.5, 0.8> translate 1 * x }
    sturm
    pigment { rgb <0.3, 0.6, 0.8> }
  }
  plane { <0, -0.4, 1>, -0.35 pigment { rgb <0.9, 0.8, 0.3> } }
  rotate 20 * y
  scale 1.2
}
