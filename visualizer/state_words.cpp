#include "state_words.h"

namespace raysteps::view {

const Words<ModelStyle>& model_words() {
    static const Words<ModelStyle> words{{"transparent", ModelStyle::transparent},
                                         {"wireframe", ModelStyle::wireframe},
                                         {"solid", ModelStyle::solid},
                                         {"hidden", ModelStyle::hidden}};
    return words;
}

const Words<CellFilter>& filter_words() {
    static const Words<CellFilter> words{{"occupied", CellFilter::occupied},
                                         {"visited", CellFilter::visited},
                                         {"tested", CellFilter::tested},
                                         {"all", CellFilter::all}};
    return words;
}

const Words<CellColor>& color_words() {
    static const Words<CellColor> words{{"depth", CellColor::depth},
                                        {"triangles", CellColor::triangles},
                                        {"cost", CellColor::cost},
                                        {"visits", CellColor::visits}};
    return words;
}

const Words<HeatMap>& heat_map_words() {
    static const Words<HeatMap> words{
        {"none", HeatMap::none}, {"visits", HeatMap::visits}, {"tests", HeatMap::tests}};
    return words;
}

const Words<SortBy>& sort_words() {
    static const Words<SortBy> words{{"id", SortBy::id},
                                     {"depth", SortBy::depth},
                                     {"count", SortBy::count},
                                     {"area", SortBy::area},
                                     {"cost", SortBy::cost}};
    return words;
}

} // namespace raysteps::view
