// Where each method fails.

function startFailures() {
  byId("failures").hidden = true;
}
