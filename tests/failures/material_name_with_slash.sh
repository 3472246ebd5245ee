sed 's/"soft"/"soft\/wet"/' joint.geo >material_name_with_slash.geo
