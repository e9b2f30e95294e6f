/** The engine as the rest of the world sees it: kernels, connections, embedding. */
@NullMarked
package org.urbi.kernel;

import org.jspecify.annotations.NullMarked;
