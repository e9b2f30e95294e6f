package org.urbi.kernel.library.exception;

import org.urbi.builtins.UrbiType;

/** The exception about keys that are not there (manual, "Dictionary.get"). */
@UrbiType(
    value = "Dictionary.KeyError",
    protos = "Exception",
    doc = "Thrown when a dictionary has no value for a key, which is its slot `key'.")
final class DictionaryKeyError {
  private DictionaryKeyError() {}
}
