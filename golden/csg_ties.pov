// Which part of a solid is seen where faces of parts lie in one place: children of one level, nested, in all operations,
// clipped, bounded, inverted (a union inverted twice has become a merge); 48 solids, each a cell of the picture.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10 * z direction z right 8 * x up 6 * y }
background { rgb <.4, .4, .5> }
#default { finish { ambient 1 diffuse 0 } }
#macro Colour(I) rgb <mod(I * 5, 16) + 1, mod(I * 3, 16) + 1, mod(I * 7, 16) + 1> / 16 #end
#macro B(I, Low, High) box { <-.4, -.4, Low>, <.4, .4, High> pigment { Colour(I) } } #end
#macro A(I, Low) plane { -z, -Low pigment { Colour(I) } } #end
#macro Z(I, High) plane { z, High pigment { Colour(I) } } #end
#macro Cell(Column, Row, Solid) object { Solid bounded_by { box { <-.49, -.49, -50>, <.49, .49, 50> } } translate <Column - 3.5, 2.5 - Row, 0> } #end


// intersections
Cell(0, 0, intersection { intersection { B(1, 0, 1) A(2, 0) } intersection { Z(3, 1) B(4, 0, 1) } })
Cell(1, 0, intersection { intersection { B(1, 0, 2) A(2, 0) Z(3, 1) } intersection { Z(4, 0) A(5, 0) } })
Cell(2, 0, intersection { intersection { B(1, 1, 2) B(2, 0, 1) B(3, 0, 1) } Z(4, 1) intersection { B(5, 0, 1) Z(6, 1) } })
Cell(3, 0, intersection { B(1, 0, 1) intersection { B(2, 0, 1) B(3, 1, 3) } intersection { A(4, 0) Z(5, 1) B(6, 0, 1) } })
Cell(4, 0, intersection { intersection { B(1, 0, 1) A(2, 0) } intersection { B(3, 0, 1) B(4, 0, 1) B(5, 1, 3) B(6, 0, 2) } intersection { B(7, 0, 1) B(8, 0, 2) } })
Cell(5, 0, intersection { intersection { B(1, 0, 1) Z(2, 2) B(3, 0, 1) } A(4, -1) A(5, -1) intersection { B(6, 0, 2) A(7, 0) } })
Cell(6, 0, intersection { intersection { A(1, 0) B(2, 0, 1) Z(3, 1) } intersection { B(4, -1, 1) A(5, 0) } intersection { Z(6, 2) B(7, 0, 1) } })
Cell(7, 0, intersection { intersection { B(1, -1, 0) B(2, 0, 1) } intersection { B(3, 0, 1) B(4, 0, 2) Z(5, 1) } })

// differences
Cell(0, 1, intersection { B(1, 0, 1) A(2, 0) B(3, 1, 2) })
Cell(1, 1, intersection { intersection { Z(1, 1) B(2, -1, 1) } intersection { A(3, 0) B(4, 0, 2) } })
Cell(2, 1, difference { intersection { Z(1, 1) A(2, 0) B(3, 0, 1) } intersection { B(4, 0, 1) B(5, 0, 2) } })
Cell(3, 1, intersection { B(1, 0, 2) B(2, 0, 1) })
Cell(4, 1, difference { A(1, -1) intersection { B(2, 0, 1) Z(3, 1) B(4, 1, 3) Z(5, 1) } difference { Z(6, 2) B(7, 0, 1) } intersection { A(8, 0) B(9, 0, 2) } })
Cell(5, 1, difference { intersection { B(1, 0, 1) Z(2, 2) B(3, 0, 1) B(4, 0, 1) } difference { B(5, 0, 1) Z(6, 1) A(7, 0) } difference { A(8, 0) B(9, -1, 0) } })
Cell(6, 1, difference { B(1, 1, 2) difference { A(2, -1) B(3, 1, 3) } difference { B(4, 1, 2) B(5, 1, 3) } intersection { Z(6, 1) A(7, 0) } })
Cell(7, 1, intersection { intersection { B(1, 1, 2) B(2, 0, 1) } intersection { A(3, 0) B(4, 0, 1) } })

// merges
Cell(0, 2, merge { intersection { B(1, 1, 2) B(2, -1, 1) B(3, -1, 0) A(4, 0) } intersection { B(5, -1, 1) Z(6, 1) B(7, 0, 2) B(8, 0, 1) } })
Cell(1, 2, merge { intersection { B(1, 0, 2) B(2, 0, 1) B(3, 0, 1) } intersection { B(4, 0, 2) B(5, 0, 2) } intersection { B(6, 0, 1) A(7, 0) } })
Cell(2, 2, intersection { intersection { Z(1, 1) B(2, 0, 1) Z(3, 3) Z(4, 1) } intersection { A(5, 0) B(6, 0, 1) } merge { Z(7, 2) B(8, 0, 1) } A(9, -1) })
Cell(3, 2, intersection { merge { A(1, 1) B(2, 0, 1) } intersection { Z(3, 2) B(4, 0, 2) } merge { B(5, 1, 2) B(6, 0, 1) B(7, 1, 2) } })
Cell(4, 2, intersection { merge { B(1, 0, 1) B(2, 0, 1) Z(3, 1) } B(4, 0, 2) intersection { B(5, 0, 1) Z(6, 1) } Z(7, 2) })
Cell(5, 2, intersection { intersection { Z(1, 1) B(2, 1, 2) B(3, -1, 1) } merge { B(4, 0, 2) B(5, 0, 1) } intersection { Z(6, 2) B(7, 0, 1) } })
Cell(6, 2, intersection { B(1, 0, 1) intersection { B(2, 0, 1) A(3, 0) } })
Cell(7, 2, intersection { A(1, 0) intersection { B(2, 0, 2) B(3, 0, 1) A(4, 1) B(5, 0, 1) } })

// unions
Cell(0, 3, union { union { A(1, 0) B(2, 0, 2) A(3, 1) split_union off } union { Z(4, 1) Z(5, 2) split_union off } split_union off })
Cell(1, 3, intersection { union { B(1, -1, 1) A(2, 0) B(3, -1, 0) B(4, 0, 1) split_union off } union { Z(5, 1) A(6, 1) B(7, -1, 1) split_union off } })
Cell(2, 3, intersection { union { B(1, 0, 1) B(2, 0, 1) B(3, -1, 0) split_union off } intersection { B(4, 0, 2) Z(5, 2) } })
Cell(3, 3, intersection { union { B(1, -1, 1) B(2, 1, 3) B(3, 0, 1) A(4, 0) split_union off } union { B(5, 0, 2) B(6, 0, 1) B(7, 0, 1) A(8, 0) split_union off } })
Cell(4, 3, union { union { A(1, 1) Z(2, 2) split_union off } union { Z(3, 3) B(4, 0, 2) B(5, 0, 2) A(6, 1) split_union off } split_union off })
Cell(5, 3, union { union { B(1, 0, 2) B(2, 1, 3) B(3, 0, 2) split_union off } B(4, 0, 1) split_union off })
Cell(6, 3, intersection { intersection { Z(1, 1) A(2, 1) B(3, 0, 1) } A(4, 0) union { B(5, 0, 2) Z(6, 2) B(7, 0, 1) split_union off } })
Cell(7, 3, union { union { B(1, 0, 1) Z(2, 2) B(3, 0, 1) split_union off } intersection { B(4, 0, 2) B(5, 0, 2) A(6, 0) A(7, 0) } split_union off })

// clipped and bounded
Cell(0, 4, union { intersection { B(1, 0, 1) B(2, -1, 1) B(3, 1, 2) } intersection { B(4, 0, 1) object { B(5, 0, 1) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } object { B(6, 0, 1) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } } split_union off clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } })
Cell(1, 4, intersection { difference { object { B(1, 0, 1) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } A(2, 0) } intersection { object { A(3, -1) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } } object { A(4, 0) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 0.5> } } } } })
Cell(2, 4, union { difference { Z(1, 1) B(2, 1, 2) clipped_by { plane { -z, 0 } } } intersection { object { B(3, 0, 1) clipped_by { plane { z, 0.5 } } } A(4, 0) } merge { B(5, 1, 2) object { A(6, 0) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } } clipped_by { plane { -z, 0 } } } split_union off clipped_by { box { <-.4, -.4, 0>, <.4, .4, 3> } } })
Cell(3, 4, merge { difference { A(1, 1) A(2, 1) object { B(3, 0, 1) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } } B(4, 0, 2) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 0.5> } } } intersection { Z(5, 1) Z(6, 3) Z(7, 2) Z(8, 1) } clipped_by { plane { -z, 0 } } })
Cell(4, 4, union { union { A(1, -1) object { B(2, 0, 1) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } } split_union off } merge { object { B(3, 0, 1) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } object { B(4, 0, 2) clipped_by { plane { -z, 0 } } bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } B(5, -1, 0) B(6, 1, 2) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } B(7, 0, 2) A(8, 0) split_union off })
Cell(5, 4, union { intersection { B(1, 1, 2) object { Z(2, 1) clipped_by { plane { z, 0.5 } } } clipped_by { box { <-.4, -.4, 0>, <.4, .4, 3> } } } difference { B(3, 0, 1) B(4, 0, 1) clipped_by { plane { -z, 0 } } bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } B(5, -1, 0) split_union off clipped_by { plane { -z, 0 } } })
Cell(6, 4, difference { union { object { A(1, 0) clipped_by { plane { -z, 0 } } } B(2, 0, 1) split_union off } object { Z(3, 1) clipped_by { box { <-.4, -.4, 0>, <.4, .4, 3> } } } })
Cell(7, 4, union { intersection { A(1, 1) object { B(2, 0, 1) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } } difference { object { Z(3, 1) clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } } Z(4, 2) bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } } split_union off bounded_by { box { <-.5, -.5, -30>, <.5, .5, 30> } } })

// inverted
Cell(0, 5, intersection { union { object { A(1, 0) clipped_by { plane { z, 0.5 } } } object { B(2, -1, 1) inverse } object { B(3, -1, 0) inverse } split_union off } union { object { A(4, 0) inverse } B(5, 0, 1) B(6, 1, 2) B(7, 0, 1) split_union off } })
Cell(1, 5, intersection { union { object { B(1, 0, 1) clipped_by { plane { z, 0.5 } } } B(2, 0, 2) B(3, 0, 1) split_union off } union { B(4, 0, 1) object { B(5, 1, 2) inverse } B(6, 0, 1) B(7, 1, 3) split_union off } })
Cell(2, 5, union { difference { A(1, 0) B(2, 0, 1) } union { object { A(3, 1) inverse clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } } B(4, 0, 1) split_union off } split_union off })
Cell(3, 5, intersection { intersection { B(1, 0, 2) B(2, 0, 1) } union { B(3, 0, 2) B(4, 0, 1) split_union off } merge { B(5, 0, 1) Z(6, 2) } })
Cell(4, 5, difference { difference { B(1, 1, 2) object { A(2, 0) inverse } } merge { Z(3, 1) B(4, -1, 1) object { A(5, 1) inverse } inverse } inverse })
Cell(5, 5, merge { union { object { A(1, 0) inverse clipped_by { plane { z, 0.5 } } } object { B(2, 0, 1) inverse } object { B(3, 0, 2) clipped_by { plane { z, 0.5 } } } split_union off } difference { B(4, 1, 3) object { Z(5, 1) inverse } } intersection { object { B(6, 0, 1) inverse } A(7, -1) } })
Cell(6, 5, union { intersection { Z(1, 1) B(2, 0, 1) B(3, 0, 2) object { B(4, 0, 2) inverse } } B(5, 0, 2) split_union off clipped_by { plane { z, 0.5 } } })
Cell(7, 5, union { A(1, 0) merge { B(2, 0, 1) object { B(3, 1, 3) inverse } } difference { B(4, 0, 1) object { B(5, 0, 2) inverse } } merge { object { Z(6, 2) inverse } B(7, -1, 0) B(8, 0, 1) B(9, -1, 1) } split_union off clipped_by { box { <-.4, -.4, -3>, <.4, .4, 3> } } })
