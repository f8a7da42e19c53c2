// blob: spheres that flow together, with threshold and a negative component.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

blob {
  threshold 0.5
  sphere { <-0.8, 0, 0>, 1.2, 1 }
  sphere { <0.7, 0.2, 0>, 1.2, 1 }
  sphere { <0, 0.9, 0>, 0.9, 1.2 }
  sphere { <0.1, 0.2, -0.9>, 0.8, -1.5 }
  scale 1.4
  pigment { rgb <0.8, 0.5, 0.2> }
  finish { phong 0.5 }
}
