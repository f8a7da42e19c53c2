// What parts of blobs take.
#version 3.7;
blob { sphere { 0, 1, 1 no_shadow } }
