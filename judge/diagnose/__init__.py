"""Why a submission is wrong: the simplest case that breaks it, the name of the mistake."""
