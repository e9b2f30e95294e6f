/** The exceptions that the language throws (manual, "Exception"). */
@NullMarked
package org.urbi.kernel.library.exception;

import org.jspecify.annotations.NullMarked;
