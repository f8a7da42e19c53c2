// Light mirrored by the inside of a ring.
#version 3.7;
global_settings { assumed_gamma 2.2 photons { count 20000 autostop 0 } }
camera { location <0, 5, -5> look_at <0, 0, 0> right 4/3*x up y angle 35 }
light_source { <3, 4, -3>, rgb <1, 0.95, 0.8> }
plane { y, 0 pigment { rgb 0.7 } finish { ambient 0.1 diffuse 0.7 } }
difference {
  cylinder { 0, 0.6*y, 1.2 } cylinder { -y, y, 1.1 }
  pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0 diffuse 0.1 reflection { 0.8 metallic } metallic }
  photons { target reflection on refraction off }
}
