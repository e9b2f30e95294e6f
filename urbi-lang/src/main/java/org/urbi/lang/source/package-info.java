/** Source texts and locations in them. */
@NullMarked
package org.urbi.lang.source;

import org.jspecify.annotations.NullMarked;
