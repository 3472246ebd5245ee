sed 's/"soft"/"h\xe4rter"/' joint.geo >material_name_not_utf8.geo
