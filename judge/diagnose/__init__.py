"""Why a submission is wrong: the simplest case that breaks it, its picture, the name of the mistake."""
