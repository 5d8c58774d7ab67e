#include "trade_offs.h"

namespace raysteps {

const std::vector<TradeOffMaker>& trade_off_makers() {
    static const std::vector<TradeOffMaker> all{
        {"triangle",
         [](const TradeOffRequest& r) { return triangle_trade_off("triangle", r.mesh, r.effort); }},
        {"slivers",
         [](const TradeOffRequest& r) {
             return triangle_trade_off("triangle, slivers", slivers_subject(), r.effort);
         }},
        {"picture",
         [](const TradeOffRequest& r) { return hit_picture_trade_off(r.scene, r.effort); }},
        {"precision", [](const TradeOffRequest& r) { return precision_trade_off(r.effort); }},
        {"slab", [](const TradeOffRequest& r) { return slab_trade_off(r.effort); }},
        {"offset", [](const TradeOffRequest& r) { return offset_trade_off(r.effort); }},
        {"primary", [](const TradeOffRequest& r) { return primary_trade_off(r.effort); }},
        {"grid", [](const TradeOffRequest& r) { return grid_trade_off(r.effort); }},
        {"samples", [](const TradeOffRequest& r) { return samples_trade_off(r.effort); }},
        {"depth", [](const TradeOffRequest& r) { return depth_trade_off(r.effort); }},
        {"lamp", [](const TradeOffRequest& r) { return lamp_trade_off(r.effort); }},
        {"speed",
         [](const TradeOffRequest& r) { return speed_trade_off(r.scene->scene, r.effort); }}};
    return all;
}

} // namespace raysteps
