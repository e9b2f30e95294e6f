/** The object model: slots, prototypes, shapes, properties; knows nothing of code. */
@NullMarked
package org.urbi.kernel.object;

import org.jspecify.annotations.NullMarked;
