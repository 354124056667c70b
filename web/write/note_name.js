/** What code calls to note a variable, where it is run to be looked at. */
export const kNote = "$note";
