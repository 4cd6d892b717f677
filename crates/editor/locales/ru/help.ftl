## Help and the guided tour.
