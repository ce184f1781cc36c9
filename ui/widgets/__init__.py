"""Controls that know nothing of faces or documents."""
