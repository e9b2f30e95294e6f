/**
 * Strings, characters, bytes, patterns and formats (manual, "String", "Binary", "Regexp",
 * "Formatter").
 */
@NullMarked
package org.urbi.kernel.library.text;

import org.jspecify.annotations.NullMarked;
