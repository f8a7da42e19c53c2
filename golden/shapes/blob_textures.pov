// blob: components with textures of their own, blended by their field.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

blob {
  threshold 0.45
  sphere { <-1, 0, 0>, 1.3, 1 texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.6 } } }
  sphere { <0.8, 0.4, 0>, 1.3, 1 texture { pigment { checker rgb 1 rgb <0.1, 0.3, 0.8> scale 0.3 } } }
  cylinder { <-0.4, -1, 0>, <0.9, -0.8, 0>, 0.7, 1 }
  scale 1.3
  pigment { rgb <0.9, 0.8, 0.3> }
}
