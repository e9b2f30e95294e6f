/** What is written about the library, and {@code help}, which shows it. */
@NullMarked
package org.urbi.kernel.library.reference;

import org.jspecify.annotations.NullMarked;
