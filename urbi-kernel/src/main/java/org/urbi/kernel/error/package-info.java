/** The errors of the language and their texts. */
@NullMarked
package org.urbi.kernel.error;

import org.jspecify.annotations.NullMarked;
