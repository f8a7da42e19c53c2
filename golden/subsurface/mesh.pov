// A closed mesh of smooth triangles, and copies of it.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 150, 30 } }
camera { location <0, 1.5, -5> look_at 0 right 4/3*x up y angle 40 }
light_source { <5, 5, -3>, rgb 0.9 }
light_source { <-4, 2, 5>, rgb 0.5 }
#declare Octahedron = mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  face_indices { 8, <0, 2, 4>, <0, 5, 2>, <0, 4, 3>, <0, 3, 5>, <1, 4, 2>, <1, 2, 5>, <1, 3, 4>, <1, 5, 3> }
  inside_vector y
}
#declare Jade = texture { pigment { rgb <0.4, 0.7, 0.45> } finish { ambient 0 diffuse 0.8 phong 0.3 subsurface { translucency <0.8, 1.2, 0.7> } } }
object { Octahedron texture { Jade } interior { ior 1.6 } translate -1.2*x }
object { Octahedron scale <0.8, 1.3, 0.8> rotate 30*y texture { Jade } interior { ior 1.6 } translate 1.1*x }
