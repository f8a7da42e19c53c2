// whitted: expanded scene, format 1
sphere { <0, 0, 0>, 1 }
